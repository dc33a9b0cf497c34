#include <algorithm>

#include "frame/whole_file.h"
#include "reports/base64.h"
#include "reports/class_style.h"
#include "reports/deep_link.h"
#include "reports/html_parts.h"
#include "reports/planes/container.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using nlohmann::json;

constexpr int tiers = 5;

/// In which round a block asks for room in the page: what finds a defect, who was seen there, how deep, what
/// witnesses say, colours.
int tier_of(const std::string& block) {
    if (block.ends_with(".colour")) return 4;
    if (block.starts_with("witness.")) return 3;
    if (block.ends_with(".depth") || block == "reference.error") return 2;
    return block.find('.') == std::string::npos ? 0 : 1;
}

/// A view's blocks, and which of them the page takes.
struct Choice {
    const PageView* page = nullptr;
    std::filesystem::path file;
    std::vector<std::string> names;
    std::vector<std::string> guesses;  ///< the block that decoding takes besides; empty: none
    std::vector<std::size_t> sizes;
    std::vector<bool> taken;
};

Choice choice_for(const PageView& page, const std::filesystem::path& run_folder) {
    Choice choice{.page = &page,
                  .file = run_folder / page.view->folder / "planes.zvp",
                  .names = {},
                  .guesses = {},
                  .sizes = {},
                  .taken = {}};
    if (page.view->folder.empty() || !std::filesystem::exists(choice.file)) return choice;
    for (const planes::Block& block :
         planes::unpacked(content_of(choice.file), choice.file.string()).blocks) {
        choice.names.push_back(block.name);
        choice.guesses.push_back(block.facts.value("beside", ""));
        choice.sizes.push_back(block.content.size());
    }
    choice.taken.resize(choice.names.size(), false);
    return choice;
}

/// Is there what decoding block i needs? Guesses stand before what is guessed from them.
bool has_guess(const Choice& choice, std::size_t i) {
    if (choice.guesses[i].empty()) return true;
    const auto guess = std::ranges::find(choice.names, choice.guesses[i]);
    return guess != choice.names.end() && choice.taken[std::size_t(guess - choice.names.begin())];
}

/// Takes what fits of one tier.
void take(Choice& choice, int tier, std::size_t& budget) {
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
        const std::size_t cost = (choice.sizes[i] + 2) / 3 * 4 + 200;  // base64, and its line in the header
        if (choice.taken[i] || tier_of(choice.names[i]) != tier || cost > budget || !has_guess(choice, i))
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

std::string planes_element(const Choice& choice) {
    if (std::ranges::count(choice.taken, true) == 0) return "";
    planes::Container all = planes::unpacked(content_of(choice.file), choice.file.string());
    planes::Container kept{std::move(all.header), {}};
    for (std::size_t i = 0; i < all.blocks.size(); ++i)
        if (choice.taken[i]) kept.blocks.push_back(std::move(all.blocks[i]));
    return "<script type=\"application/zvp\" id=\"planes-" + choice.page->anchor + "\">" +
           base64(planes::packed(kept)) + "</script>\n";
}

json left_out(const Choice& choice) {
    json names = json::array();
    for (std::size_t i = 0; i < choice.names.size(); ++i)
        if (!choice.taken[i]) names.push_back(choice.names[i]);
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
               {"planes", !choice.names.empty()}};
    if (v.diagnosis && v.diagnosis->cause) facts["cause"] = one_line(v.diagnosis->cause->name);
    return facts;
}

std::string colour_text(Rgb8 c) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : {c.r, c.g, c.b}) text += {hex[channel >> 4], hex[channel & 15]};
    return text;
}

json classes() {
    json all = json::array();
    for (int i = 0; i < pixel_class_count; ++i) {
        const ClassStyle& style = style_of(PixelClass(i));
        all.push_back({{"name", name_of(PixelClass(i))},
                       {"glyph", style.glyph},
                       {"colour", colour_text(style.colour)},
                       {"meaning", style.meaning},
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
    PagePlanes planes;
    for (const Choice& choice : choices) {
        views.push_back(facts_of(choice));
        planes.elements += planes_element(choice);
        for (std::size_t i = 0; i < choice.names.size(); ++i)
            if (!choice.taken[i]) ++planes.blocks_left_out, planes.bytes_left_out += choice.sizes[i];
    }
    planes.elements =
        json_element("run", {{"views", std::move(views)}, {"classes", classes()}}) + planes.elements;
    return planes;
}

}  // namespace zproof
