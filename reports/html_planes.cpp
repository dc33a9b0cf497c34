#include <algorithm>

#include "reports/class_colour.h"
#include "reports/deep_link.h"
#include "reports/html_parts.h"
#include "reports/page_parts.h"
#include "reports/planes/container.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using nlohmann::json;

constexpr int tiers = 5;

/// The round in which a block asks for room in the page: what finds a defect, who was seen there, how deep,
/// what oracles say, colours.
int tier_of(const std::string& block) {
    if (block.ends_with(".colour")) return 4;
    if (block.starts_with("oracle.")) return 3;
    if (block.ends_with(".depth") || block == "reference.error") return 2;
    return block.find('.') == std::string::npos ? 0 : 1;
}

/// A view's blocks, and which of them the page takes.
struct Choice {
    const PageView* page = nullptr;
    std::filesystem::path file;
    planes::Directory directory;
    std::vector<bool> taken;  ///< of the directory's blocks
};

Choice choice_for(const PageView& page, const std::filesystem::path& run_folder) {
    Choice choice{
        .page = &page, .file = run_folder / page.view->folder / "planes.zvp", .directory = {}, .taken = {}};
    if (page.view->folder.empty() || !std::filesystem::exists(choice.file)) return choice;
    choice.directory = planes::directory_of(choice.file);
    choice.taken.resize(choice.directory.blocks.size(), false);
    return choice;
}

/// Is there what decoding block i needs? Guesses stand before what is guessed from them.
bool has_guess(const Choice& choice, std::size_t i) {
    const std::vector<planes::BlockPlace>& blocks = choice.directory.blocks;
    const std::string name = blocks[i].facts.value("beside", "");
    if (name.empty()) return true;
    const auto guess = std::ranges::find(blocks, name, &planes::BlockPlace::name);
    return guess != blocks.end() && choice.taken[std::size_t(guess - blocks.begin())];
}

/// Takes what fits of one tier.
void take(Choice& choice, int tier, std::size_t& budget) {
    for (std::size_t i = 0; i < choice.taken.size(); ++i) {
        const planes::BlockPlace& block = choice.directory.blocks[i];
        const std::size_t cost = (block.size + 2) / 3 * 4 + 200;  // base64, and its line in the header
        if (choice.taken[i] || tier_of(block.name) != tier || cost > budget || !has_guess(choice, i))
            continue;
        choice.taken[i] = true;
        budget -= cost;
    }
}

/// Classes of every view first; then all of failed views; then the others, tier by tier.
void choose(std::vector<Choice>& choices, std::size_t budget) {
    for (Choice& choice : choices) take(choice, 0, budget);
    for (Choice& choice : choices)
        for (int tier = 1; tier < tiers && choice.page->view->outcome == Outcome::defective; ++tier)
            take(choice, tier, budget);
    for (int tier = 1; tier < tiers; ++tier)
        for (Choice& choice : choices) take(choice, tier, budget);
}

/// A container of the blocks that were taken.
FileAsBase64 taken_from(const Choice& choice) {
    FileAsBase64 bytes{.front = {}, .file = choice.file, .ranges = {}};
    planes::Directory kept{choice.directory.header, {}};
    for (std::size_t i = 0; i < choice.taken.size(); ++i) {
        if (!choice.taken[i]) continue;
        kept.blocks.push_back(choice.directory.blocks[i]);
        bytes.ranges.push_back({kept.blocks.back().first, kept.blocks.back().size});
    }
    bytes.front = planes::packed_front(kept);
    return bytes;
}

void append_planes(Page& page, const Choice& choice) {
    if (std::ranges::count(choice.taken, true) == 0) return;
    page.emplace_back("<script type=\"application/zvp\" id=\"planes-" + choice.page->anchor + "\">");
    page.emplace_back(taken_from(choice));
    page.emplace_back("</script>\n");
}

json left_out(const Choice& choice) {
    json names = json::array();
    for (std::size_t i = 0; i < choice.taken.size(); ++i)
        if (!choice.taken[i]) names.push_back(choice.directory.blocks[i].name);
    return names;
}

json facts_of(const Choice& choice) {
    const ViewResult& v = *choice.page->view;
    json facts{{"anchor", choice.page->anchor},
               {"link", link_name(v)},
               {"folder", v.folder},
               {"scene", one_line(v.scene)},
               {"view", one_line(v.view)},
               {"outcome", name_of(v.outcome)},
               {"message", one_line(v.message)},
               {"candidate", one_line(v.candidate)},
               {"reference", one_line(v.reference)},
               {"width", v.width},
               {"height", v.height},
               {"triangles", v.triangles},
               {"counts", v.counts},
               {"leftOut", left_out(choice)},
               {"planes", !choice.taken.empty()}};
    if (v.diagnosis && v.diagnosis->cause) facts["cause"] = one_line(v.diagnosis->cause->name);
    return facts;
}

json classes() {
    json all = json::array();
    for (int i = 0; i < pixel_class_count; ++i) {
        const ClassFacts facts = facts_of(PixelClass(i));
        all.push_back({{"name", facts.name},
                       {"glyph", facts.glyph},
                       {"colour", css_colour(colour_of(PixelClass(i)))},
                       {"meaning", facts.meaning},
                       {"passes", passes(PixelClass(i))}});
    }
    return all;
}

/// JSON that no text in it can end the element of.
std::string json_element(const std::string& id, const json& content) {
    std::string text;
    for (const char c : content.dump(-1, ' ', false, json::error_handler_t::replace))
        text += c == '<' ? "\\u003c" : std::string(1, c);
    return "<script type=\"application/json\" id=\"" + id + "\">" + text + "</script>\n";
}

}  // namespace

PagePlanes page_planes(const std::vector<PageView>& pages, const std::filesystem::path& run_folder,
                       std::size_t budget) {
    std::vector<Choice> choices;
    for (const PageView& page : pages) choices.push_back(choice_for(page, run_folder));
    json views = json::array();
    choose(choices, budget);
    for (const Choice& choice : choices) views.push_back(facts_of(choice));
    PagePlanes planes;
    planes.elements.emplace_back(json_element("run", {{"views", std::move(views)}, {"classes", classes()}}));
    for (const Choice& choice : choices) {
        append_planes(planes.elements, choice);
        for (std::size_t i = 0; i < choice.taken.size(); ++i) {
            if (choice.taken[i]) continue;
            ++planes.blocks_left_out;
            planes.bytes_left_out += choice.directory.blocks[i].size;
        }
    }
    return planes;
}

}  // namespace zproof
