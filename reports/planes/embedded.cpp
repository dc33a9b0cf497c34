#include "reports/planes/embedded.h"

#include <algorithm>

#include "reports/wording.h"

namespace zproof::planes {

namespace {

/// A container of some blocks, in their order.
FileAsBase64 container_of(const std::filesystem::path& file, Directory kept) {
    FileAsBase64 bytes{.front = packed_front(kept), .file = file, .ranges = {}};
    for (const BlockPlace& block : kept.blocks) bytes.ranges.push_back({block.first, block.size});
    return bytes;
}

}  // namespace

EmbeddedPlanes::EmbeddedPlanes(std::vector<PlanesFile> files, const Tiers& tiers, std::size_t budget)
    : tiers_(tiers) {
    for (PlanesFile& source : files) {
        Choice choice{std::move(source), {}, {}};
        if (std::filesystem::exists(choice.source.file)) {
            choice.directory = directory_of(choice.source.file);
            choice.taken.resize(choice.directory.blocks.size(), false);
        }
        choices_.push_back(std::move(choice));
    }
    const auto first = std::ranges::find_if(choices_, [](const Choice& c) { return c.source.goes_first; });
    for (int tier = 0; first != choices_.end() && tier < tiers.count; ++tier) take(*first, tier, budget);
    for (Choice& choice : choices_) take(choice, 0, budget);
    for (Choice& choice : choices_)
        for (int tier = 1; tier < tiers.count && choice.source.goes_first; ++tier) take(choice, tier, budget);
    for (int tier = 1; tier < tiers.count; ++tier)
        for (Choice& choice : choices_) take(choice, tier, budget);
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
void EmbeddedPlanes::take(Choice& choice, int tier, std::size_t& budget) const {
    for (std::size_t i = 0; i < choice.taken.size(); ++i) {
        const BlockPlace& block = choice.directory.blocks[i];
        const std::size_t cost = (block.size + 2) / 3 * 4 + 200;  // base64, and its line in the header
        if (choice.taken[i] || tiers_.of(block.name) != tier || cost > budget || !has_guess(choice, i))
            continue;
        choice.taken[i] = true;
        budget -= cost;
    }
}

/// The groups of what was not taken.
std::vector<EmbeddedPlanes::Group> EmbeddedPlanes::groups_beside(const Choice& choice) const {
    std::vector<Group> groups;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < choice.taken.size() && tiers_.script_of != nullptr; ++i) {
        if (choice.taken[i]) continue;
        const std::string name = tiers_.script_of(choice.directory.blocks[i].name);
        const std::size_t at = std::size_t(std::ranges::find(names, name) - names.begin());
        if (at == names.size()) {
            names.push_back(name);
            groups.push_back(
                {"planes/" + choice.source.anchor + "-" + std::to_string(names.size()) + ".js", {}});
        }
        groups[at].blocks.push_back(i);
    }
    return groups;
}

FileAsBase64 EmbeddedPlanes::taken_from(const Choice& choice) const {
    Directory kept{choice.directory.header, {}};
    if (const nlohmann::json names = left_out(choice); !names.empty()) kept.header["leftOut"] = names;
    for (const Group& group : groups_beside(choice))
        for (const std::size_t i : group.blocks)
            kept.header["scripts"][group.script].push_back(choice.directory.blocks[i].name);
    for (std::size_t i = 0; i < choice.taken.size(); ++i)
        if (choice.taken[i]) kept.blocks.push_back(choice.directory.blocks[i]);
    return container_of(choice.source.file, std::move(kept));
}

void EmbeddedPlanes::append_to(Page& page) const {
    for (const Choice& choice : choices_) {
        if (choice.taken.empty()) continue;
        if (tiers_.script_of == nullptr && std::ranges::count(choice.taken, true) == 0) continue;
        page.emplace_back("<script type=\"application/zvp\" id=\"planes-" + choice.source.anchor + "\">");
        page.emplace_back(taken_from(choice));
        page.emplace_back("</script>\n");
    }
}

std::vector<ScriptFile> EmbeddedPlanes::scripts() const {
    std::vector<ScriptFile> scripts;
    for (const Choice& choice : choices_)
        for (const Group& group : groups_beside(choice)) {
            Directory kept{nlohmann::json::object(), {}};
            for (const std::size_t i : group.blocks) kept.blocks.push_back(choice.directory.blocks[i]);
            scripts.push_back({group.script,
                               {"zproofPlanes(\"" + group.script + "\",\"",
                                container_of(choice.source.file, std::move(kept)), std::string{"\")\n"}}});
        }
    return scripts;
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
    const std::string what =
        counted(blocks, "plane") + " (" + fixed(double(bytes) / 1e6, 1) + " MB) of the views ";
    if (tiers_.script_of != nullptr)
        return "<p class=\"facts\">" + what +
               "lie beside this page, in planes/. A page that was moved without that folder opens each "
               "view&#39;s planes.zvp when it is dropped on it.</p>\n";
    return "<p class=\"facts\">To keep this page small, " + what +
           "are left out of it. They are in each view&#39;s planes.zvp; the viewer opens such a file when it "
           "is "
           "dropped on it.</p>\n";
}

std::string json_element(const std::string& id, const nlohmann::json& content) {
    std::string text;
    for (const char c : content.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
        text += c == '<' ? "\\u003c" : std::string(1, c);
    return "<script type=\"application/json\" id=\"" + id + "\">" + text + "</script>\n";
}

}  // namespace zproof::planes
