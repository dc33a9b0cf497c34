#include "reports/planes/container.h"

#include <cstring>

namespace zproof::planes {

namespace {

constexpr std::string_view magic = "ZVP1";

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

/// The front of `text`, which loses it. Throws where there is not so much.
std::string_view taken(std::string_view& text, std::size_t length) {
    if (text.size() < length) throw ReportError("ends early");
    const std::string_view front = text.substr(0, length);
    text.remove_prefix(length);
    return front;
}

Container unpacked(std::string_view text) {
    if (taken(text, magic.size()) != magic) throw ReportError("does not begin with ZVP1");
    const std::size_t length = length_at(taken(text, 4));
    Container container{nlohmann::json::parse(taken(text, length)), {}};
    for (const nlohmann::json& facts : container.header.at("blocks")) {
        Block block{facts.at("name"), facts, {}};
        block.content = taken(text, facts.at("bytes").get<std::size_t>());
        block.facts.erase("name");
        block.facts.erase("bytes");
        container.blocks.push_back(std::move(block));
    }
    container.header.erase("blocks");
    return container;
}

}  // namespace

std::string packed(const Container& container) {
    nlohmann::json header = container.header;
    header["blocks"] = nlohmann::json::array();
    for (const Block& block : container.blocks) {
        nlohmann::json facts = block.facts;
        facts["name"] = block.name;
        facts["bytes"] = block.content.size();
        header["blocks"].push_back(std::move(facts));
    }
    const std::string text = header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::string bytes = std::string(magic) + length_text(text.size()) + text;
    std::size_t size = bytes.size();
    for (const Block& block : container.blocks) size += block.content.size();
    bytes.reserve(size);
    for (const Block& block : container.blocks) bytes += block.content;
    return bytes;
}

Container unpacked(std::string_view text, const std::string& place) {
    try {
        return unpacked(text);
    } catch (const ReportError& e) {
        throw ReportError(place + ": no planes of a view: " + e.what() + "; run zproof again");
    } catch (const nlohmann::json::exception& e) {
        throw ReportError(place + ": no planes of a view: its header: " + std::string(e.what()) +
                          "; run zproof again");
    }
}

}  // namespace zproof::planes
