#include <algorithm>

#include "reports/class_colour.h"
#include "reports/html_parts.h"
#include "reports/page_parts.h"
#include "reports/planes/embedded.h"

namespace zproof {

namespace {

using nlohmann::json;

constexpr int tiers = 5;
constexpr std::size_t reserve_per_view = 2'000;  // for the names of what is left out

/// The round in which a block asks for room in the page: what finds a defect, who was seen there, how deep,
/// what oracles say, colours.
int tier_of(const std::string& block) {
    if (block.ends_with(".colour")) return 4;
    if (block.starts_with("oracle.")) return 3;
    if (block.ends_with(".depth") || block == "reference.error") return 2;
    return block.find('.') == std::string::npos ? 0 : 1;
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

json columns() {
    json all = json::array();
    for (const SummaryColumn& column : summary_columns())
        all.push_back({{"kind", column.kind}, {"quietZeros", column.zeros == Zeros::quiet}});
    return all;
}

json promises(const Results& results) {
    json all = json::object();
    for (const RendererFacts& facts : results.renderers) all[facts.name] = promise_in_words(facts.precision);
    return all;
}

}  // namespace

PagePlanes page_planes(const Results& results, std::span<const PageView> views,
                       const std::filesystem::path& run_folder, std::size_t budget) {
    std::vector<planes::PlanesFile> files;
    for (const PageView& page : views)
        if (page.has_planes)
            files.push_back({page.anchor, run_folder / page.view->folder / "planes.zvp",
                             page.view->outcome == Outcome::defective});
    const std::size_t reserved = files.size() * reserve_per_view;
    const planes::EmbeddedPlanes embedded(std::move(files), {tiers, tier_of},
                                          budget - std::min(budget, reserved));
    PagePlanes planes{{}, embedded.omissions()};
    planes.elements.emplace_back(planes::json_element("run", {{"classes", classes()},
                                                              {"promises", promises(results)},
                                                              {"columns", columns()},
                                                              {"facts", fact_names()},
                                                              {"inMarkup", views_in_markup},
                                                              {"inPack", sections_in_pack}}));
    embedded.append_to(planes.elements);
    return planes;
}

}  // namespace zproof
