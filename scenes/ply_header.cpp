#include "scenes/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "scenes/refusal.h"

namespace zproof {
namespace {

using Path = std::filesystem::path;
using Words = std::vector<std::string_view>;

constexpr std::array<std::pair<std::string_view, PlyType>, 16> type_words{{
    {"char", PlyType::int8},
    {"int8", PlyType::int8},
    {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},
    {"short", PlyType::int16},
    {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},
    {"uint16", PlyType::uint16},
    {"int", PlyType::int32},
    {"int32", PlyType::int32},
    {"uint", PlyType::uint32},
    {"uint32", PlyType::uint32},
    {"float", PlyType::float32},
    {"float32", PlyType::float32},
    {"double", PlyType::float64},
    {"float64", PlyType::float64},
}};

constexpr std::array<std::pair<std::string_view, PlyHeader::Format>, 3> format_words{{
    {"ascii", PlyHeader::Format::ascii},
    {"binary_little_endian", PlyHeader::Format::little_endian},
    {"binary_big_endian", PlyHeader::Format::big_endian},
}};

Words words_of(std::string_view line) {
    Words words;
    while (true) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (line.empty()) return words;
        words.push_back(line.substr(0, line.find_first_of(" \t")));
        line.remove_prefix(words.back().size());
    }
}

class HeaderReader {
  public:
    HeaderReader(const Path& file, std::string_view content) : file_(file), content_(content) {}

    PlyHeader header() {
        if (next_line() != "ply") refuse_line("expected \"ply\" as the first line");
        Words words = words_of(next_line());
        if (words.size() != 3 || words[0] != "format" || words[2] != "1.0")
            refuse_line(
                "expected \"format ascii 1.0\", \"format binary_little_endian 1.0\" or ... big_endian");
        header_.format = meaning(format_words, words[1]);
        for (words = words_of(next_line()); words != Words{"end_header"}; words = words_of(next_line()))
            take(words);
        header_.bytes = at_;
        for (const PlyElement& element : header_.elements) check_room(element);
        return std::move(header_);
    }

  private:
    [[noreturn]] void refuse_line(const std::string& text) const {
        refuse(file_, "line " + std::to_string(line_), text + "; export the file again");
    }

    /// Without its end, "\n", "\r\n" or, before text, "\r".
    std::string_view next_line() {
        ++line_;
        const std::size_t end = content_.find_first_of("\r\n", at_);
        if (end == std::string_view::npos) refuse_line("expected more lines, up to \"end_header\"");
        const std::string_view line = content_.substr(at_, end - at_);
        at_ = end + (content_.substr(end).starts_with("\r\n") ? 2 : 1);
        return line;
    }

    template <typename Table>
    typename Table::value_type::second_type meaning(const Table& table, std::string_view word) const {
        for (const auto& [name, value] : table)
            if (name == word) return value;
        refuse_line("\"" + std::string(word.substr(0, 40)) + "\" is not a word of PLY 1.0 here");
    }

    void take(const Words& words) {
        if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return;
        if (words[0] == "element" && words.size() == 3) return take_element(words);
        const bool is_list = words.size() == 5 && words[1] == "list";
        if (words[0] != "property" || header_.elements.empty() || !(words.size() == 3 || is_list))
            refuse_line(
                "expected \"element NAME COUNT\", \"property TYPE NAME\", \"property list TYPE TYPE NAME\", "
                "\"comment ...\" or \"end_header\"");
        PlyProperty property{std::string(words.back()), meaning(type_words, words[words.size() - 2])};
        if (is_list) property.count_type = meaning(type_words, words[2]);
        header_.elements.back().properties.push_back(std::move(property));
    }

    void take_element(const Words& words) {
        std::uint64_t count = 0;
        const auto [end, error] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
        if (error != std::errc{} || end != words[2].data() + words[2].size())
            refuse_line("expected a number of elements, found \"" + std::string(words[2].substr(0, 40)) +
                        "\"");
        header_.elements.push_back({std::string(words[1]), count});
    }

    /// An element takes at least its values' sizes or, as text, a digit and a blank for each of them.
    void check_room(const PlyElement& element) const {
        std::uint64_t least = 0;
        for (const PlyProperty& property : element.properties)
            least += header_.format == PlyHeader::Format::ascii
                         ? 2
                         : bytes_of(property.count_type.value_or(property.type));
        const std::uint64_t there = content_.size() - at_ + 1;  // the last value needs no blank behind it
        if (least > 0 && element.count > there / least)
            refuse(file_, "element " + on_one_line(element.name),
                   std::to_string(element.count) + " elements need at least " + std::to_string(least) +
                       " bytes each; the file has " + std::to_string(content_.size() - at_) +
                       " behind its header: export the file again");
    }

    const Path& file_;
    std::string_view content_;
    PlyHeader header_;
    std::size_t at_ = 0, line_ = 0;
};

}  // namespace

std::size_t bytes_of(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 0;
}

PlyHeader ply_header(const Path& file, std::string_view content) {
    return HeaderReader(file, content).header();
}

}  // namespace zproof
