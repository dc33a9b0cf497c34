#include "reports/planes/embedded.h"

#include <algorithm>

#include "reports/wording.h"

namespace zproof::planes {

EmbeddedPlanes::EmbeddedPlanes(std::vector<PlanesFile> files, const Tiers& tiers, std::size_t budget) {
    for (PlanesFile& source : files) {
        Choice choice{std::move(source), {}, {}};
        if (std::filesystem::exists(choice.source.file)) {
            choice.directory = directory_of(choice.source.file);
            choice.taken.resize(choice.directory.blocks.size(), false);
        }
        choices_.push_back(std::move(choice));
    }
    const auto first = std::ranges::find_if(choices_, [](const Choice& c) { return c.source.goes_first; });
    for (int tier = 0; first != choices_.end() && tier < tiers.count; ++tier)
        take(*first, tier, tiers, budget);
    for (Choice& choice : choices_) take(choice, 0, tiers, budget);
    for (Choice& choice : choices_)
        for (int tier = 1; tier < tiers.count && choice.source.goes_first; ++tier)
            take(choice, tier, tiers, budget);
    for (int tier = 1; tier < tiers.count; ++tier)
        for (Choice& choice : choices_) take(choice, tier, tiers, budget);
}

/// Is there what decoding block i needs? Guesses stand before what is guessed from them.
bool EmbeddedPlanes::has_guess(const Choice& choice, std::size_t i) {
    const std::vector<BlockPlace>& blocks = choice.directory.blocks;
    const std::string name = blocks[i].facts.value("beside", "");
    if (name.empty()) return true;
    const auto guess = std::ranges::find(blocks, name, &BlockPlace::name);
    return guess != blocks.end() && choice.taken[std::size_t(guess - blocks.begin())];
}

/// Takes what fits of one tier.
void EmbeddedPlanes::take(Choice& choice, int tier, const Tiers& tiers, std::size_t& budget) {
    for (std::size_t i = 0; i < choice.taken.size(); ++i) {
        const BlockPlace& block = choice.directory.blocks[i];
        const std::size_t cost = (block.size + 2) / 3 * 4 + 200;  // base64, and its line in the header
        if (choice.taken[i] || tiers.of(block.name) != tier || cost > budget || !has_guess(choice, i))
            continue;
        choice.taken[i] = true;
        budget -= cost;
    }
}

/// A container of the blocks that were taken.
FileAsBase64 EmbeddedPlanes::taken_from(const Choice& choice) {
    FileAsBase64 bytes{.front = {}, .file = choice.source.file, .ranges = {}};
    Directory kept{choice.directory.header, {}};
    if (const nlohmann::json names = left_out(choice); !names.empty()) kept.header["leftOut"] = names;
    for (std::size_t i = 0; i < choice.taken.size(); ++i) {
        if (!choice.taken[i]) continue;
        kept.blocks.push_back(choice.directory.blocks[i]);
        bytes.ranges.push_back({kept.blocks.back().first, kept.blocks.back().size});
    }
    bytes.front = packed_front(kept);
    return bytes;
}

void EmbeddedPlanes::append_to(Page& page) const {
    for (const Choice& choice : choices_) {
        if (std::ranges::count(choice.taken, true) == 0) continue;
        page.emplace_back("<script type=\"application/zvp\" id=\"planes-" + choice.source.anchor + "\">");
        page.emplace_back(taken_from(choice));
        page.emplace_back("</script>\n");
    }
}

/// Names of blocks.
nlohmann::json EmbeddedPlanes::left_out(const Choice& choice) {
    nlohmann::json names = nlohmann::json::array();
    for (std::size_t i = 0; i < choice.taken.size(); ++i)
        if (!choice.taken[i]) names.push_back(choice.directory.blocks[i].name);
    return names;
}

std::string EmbeddedPlanes::omissions() const {
    std::size_t blocks = 0, bytes = 0;
    for (const Choice& choice : choices_)
        for (std::size_t i = 0; i < choice.taken.size(); ++i) {
            if (choice.taken[i]) continue;
            ++blocks;
            bytes += choice.directory.blocks[i].size;
        }
    if (blocks == 0) return "";
    return "<p class=\"facts\">To keep this page small, " + counted(blocks, "plane") + " (" +
           fixed(double(bytes) / 1e6, 1) +
           " MB) of the views are left out of it. They are in each view&#39;s planes.zvp; the viewer opens "
           "such a "
           "file when it is dropped on it.</p>\n";
}

std::string json_element(const std::string& id, const nlohmann::json& content) {
    std::string text;
    for (const char c : content.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
        text += c == '<' ? "\\u003c" : std::string(1, c);
    return "<script type=\"application/json\" id=\"" + id + "\">" + text + "</script>\n";
}

}  // namespace zproof::planes
