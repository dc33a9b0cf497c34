#include <algorithm>
#include <array>
#include <sstream>

#include "cli/waivers/waiver_file.h"
#include "frame/joined.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

std::string quoted(const std::string& text) {
    constexpr std::string_view hex = "0123456789ABCDEF";
    std::string word = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') word += '\\';
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            word += {'\\', 'u', '0', '0', hex[std::size_t(c) >> 4], hex[std::size_t(c) & 15]};
        else
            word += c;
    }
    return word + "\"";
}

std::string id_word(PrimitiveId id) {
    return id == PrimitiveId::none ? "\"background\"" : std::to_string(static_cast<std::uint32_t>(id));
}

template <class Items, class Word>
std::string list_of(const Items& items, const Word& word) {
    return "[" + joined(items, ", ", word) + "]";
}

std::string place_line(const Anywhere&) { return "allow_all = true"; }

std::string place_line(const AtTriangles& at) {
    return "where = { triangles = " + list_of(at.triangles, id_word) + " }";
}

std::string place_line(const AtPairs& at) {
    const auto pair = [](const auto& p) { return "[" + id_word(p.first) + ", " + id_word(p.second) + "]"; };
    return "where = { pairs = " + list_of(at.pairs, pair) + " }";
}

std::string place_line(const AtPixels& at) {
    const auto rectangle = [](const PixelRectangle& r) {
        return list_of(std::array{r.x, r.y, r.width, r.height}, [](int n) { return std::to_string(n); });
    };
    return "where = { rectangles = " + list_of(at.rectangles, rectangle) + ", size = [" +
           std::to_string(at.size.width) + ", " + std::to_string(at.size.height) + "] }";
}

bool opens_waiver(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first != std::string::npos && line.compare(first, 2, "[[") == 0 &&
           line.find("waiver", first) != std::string::npos;
}

bool is_comment_or_blank(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    return first == std::string::npos || line[first] == '#';
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in{text};
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// The line at which each waiver begins, and one past the last line.
std::vector<std::size_t> beginnings(const std::vector<std::string>& lines) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (opens_waiver(lines[i])) places.push_back(i);
    places.push_back(lines.size());
    return places;
}

bool holds_exactly(const std::string& text, const std::vector<Waiver>& waivers) {
    try {
        return std::ranges::equal(parse_waivers(text, ""), waivers, {}, waiver_text, waiver_text);
    } catch (const UsageError&) {
        return false;
    }
}

}  // namespace

std::string waiver_text(const Waiver& w) {
    const auto class_word = [](PixelClass c) { return "\"" + std::string{name_of(c)} + "\""; };
    std::string text = "[[waiver]]\nid = " + quoted(w.id) + "\nscene = " + quoted(w.scene) + "\n";
    if (w.view != "*") text += "view = " + quoted(w.view) + "\n";
    text += "class = " + list_of(w.classes, class_word) + "\n" +
            std::visit([](const auto& at) { return place_line(at); }, w.where) +
            "\ncount = { min = " + std::to_string(w.least) + ", max = " + std::to_string(w.most) +
            " }\nreason = " + quoted(w.reason) + "\nlink = " + quoted(w.link) +
            "\ncreated = " + in_words(w.created) + "\nexpires = " + in_words(w.expires) + "\n";
    if (!w.scene_sha256.empty()) text += "scene_sha256 = " + quoted(w.scene_sha256) + "\n";
    return text;
}

std::string empty_waiver_file() {
    return "# Waivers of zproof: docs/gate.md tells what they may say.\nformat = 1\n";
}

std::string without_waivers(const std::string& text, const std::vector<std::string>& ids,
                            const std::string& name) {
    const std::vector<std::string> lines = lines_of(text);
    std::vector<Waiver> waivers = parse_waivers(text, name);
    const std::vector<std::size_t> begin = beginnings(lines);
    std::vector<bool> goes(lines.size());
    for (std::size_t i = 0; i < waivers.size() && i + 1 < begin.size(); ++i) {
        if (std::ranges::count(ids, waivers[i].id) == 0) continue;
        std::size_t end = begin[i + 1];  // what stands right above the next is the next one's
        while (end < lines.size() && end > begin[i] + 1 && is_comment_or_blank(lines[end - 1])) --end;
        for (std::size_t line = begin[i]; line < end; ++line) goes[line] = true;
    }
    std::string rest;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (!goes[i]) rest += lines[i] + "\n";
    std::erase_if(waivers, [&](const Waiver& waiver) { return std::ranges::count(ids, waiver.id) > 0; });
    if (!holds_exactly(rest, waivers))
        throw UsageError{name + ": expected each waiver as a table [[waiver]] of its own; remove by hand: " +
                         list_of(ids, [](const std::string& id) { return id; })};
    return rest;
}

}  // namespace zproof
