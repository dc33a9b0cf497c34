#include "reports/planes/container.h"

#include <fstream>
#include <utility>

#include "frame/input_file.h"
#include "frame/whole_file.h"
#include "reports/whole_number.h"

namespace zproof::planes {

namespace {

constexpr std::string_view magic = "ZVP1";
constexpr std::size_t front_bytes = magic.size() + 4;  ///< magic and the header's length

std::string length_text(std::size_t length) {
    std::string text;
    for (int k = 0; k < 4; ++k) text += char(length >> (8 * k) & 0xFF);
    return text;
}

std::size_t length_at(std::string_view text) {
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k) length |= std::size_t(std::uint8_t(text[k])) << (8 * k);
    return length;
}

/// What a header of so many bytes, behind magic and length, says of a container of `whole` bytes in all.
Directory directory_in(std::string_view header, std::uint64_t whole) {
    Directory directory{nlohmann::json::parse(header), {}};
    std::uint64_t first = front_bytes + header.size();
    for (const nlohmann::json& facts : directory.header.at("blocks")) {
        BlockPlace block{facts.at("name"), facts, first, whole_number<std::uint64_t>(facts.at("bytes"))};
        if (block.size > whole - first) throw ReportError("ends early");
        first += block.size;
        block.facts.erase("name");
        block.facts.erase("bytes");
        directory.blocks.push_back(std::move(block));
    }
    directory.header.erase("blocks");
    return directory;
}

/// The header's length. `front`: the first bytes of a container, as many of front_bytes as there are.
std::size_t header_length_in(std::string_view front, std::uint64_t whole) {
    if (front.substr(0, magic.size()) != magic) throw ReportError("does not begin with ZVP1");
    if (front.size() < front_bytes) throw ReportError("ends early");
    const std::size_t length = length_at(front.substr(magic.size()));
    if (length > whole - front_bytes) throw ReportError("ends early");
    return length;
}

Container unpacked(std::string_view text) {
    const std::size_t length = header_length_in(text.substr(0, front_bytes), text.size());
    Directory directory = directory_in(text.substr(front_bytes, length), text.size());
    Container container{std::move(directory.header), {}};
    for (BlockPlace& block : directory.blocks)
        container.blocks.push_back({std::move(block.name), std::move(block.facts),
                                    std::string(text.substr(block.first, block.size))});
    return container;
}

Directory read_directory(const std::filesystem::path& file) {
    if (const std::string fault = fault_of_input(file); !fault.empty()) throw ReportError(fault);
    std::ifstream in(file, std::ios::binary);
    const std::uintmax_t whole = std::filesystem::file_size(file);
    const auto read = [&](std::size_t size) {
        std::string bytes(size, '\0');
        in.read(bytes.data(), std::streamsize(size));
        bytes.resize(std::size_t(in.gcount()));
        return bytes;
    };
    const std::size_t length = header_length_in(read(front_bytes), whole);
    return directory_in(read(length), whole);
}

/// What a container is written as, part by part.
template <class Add>
void for_each_part(const Container& container, const Add& add) {
    Directory directory{container.header, {}};
    std::size_t size = 0;
    for (const Block& block : container.blocks) {
        directory.blocks.push_back({block.name, block.facts, size, block.content.size()});
        size += block.content.size();
    }
    add(packed_front(directory));
    for (const Block& block : container.blocks) add(block.content);
}

/// What `read` makes of a container; where that is none, an error that names the place.
template <class Read>
auto named(const std::string& place, const Read& read) {
    try {
        return read();
    } catch (const ReportError& e) {
        throw ReportError(place + ": no planes of a view: " + e.what() + "; run zproof again");
    } catch (const nlohmann::json::exception& e) {
        throw ReportError(place + ": no planes of a view: its header: " + std::string(e.what()) +
                          "; run zproof again");
    }
}

}  // namespace

std::string packed_front(const Directory& directory) {
    nlohmann::json header = directory.header;
    header["blocks"] = nlohmann::json::array();
    for (const BlockPlace& block : directory.blocks) {
        nlohmann::json facts = block.facts;
        facts["name"] = block.name;
        facts["bytes"] = block.size;
        header["blocks"].push_back(std::move(facts));
    }
    const std::string text = header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    return std::string(magic) + length_text(text.size()) + text;
}

std::string packed(const Container& container) {
    std::string bytes;
    for_each_part(container, [&](std::string_view part) { bytes += part; });
    return bytes;
}

void write(const std::filesystem::path& file, const Container& container) {
    WholeFile whole(file);
    for_each_part(container, [&](std::string_view part) { whole.append(part); });
    whole.finish();
}

Container unpacked(std::string_view text, const std::string& place) {
    return named(place, [&] { return unpacked(text); });
}

Directory directory_of(const std::filesystem::path& file) {
    return named(file.string(), [&] { return read_directory(file); });
}

}  // namespace zproof::planes
