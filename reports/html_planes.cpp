#include <algorithm>

#include "reports/class_colour.h"
#include "reports/deep_link.h"
#include "reports/html_parts.h"
#include "reports/page_parts.h"
#include "reports/planes/embedded.h"
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

json facts_of(const PageView& page, const planes::EmbeddedPlanes& embedded, std::size_t i) {
    const ViewResult& v = *page.view;
    json facts{{"anchor", page.anchor},
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
               {"leftOut", embedded.left_out(i)},
               {"planes", embedded.has_planes(i)}};
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

}  // namespace

PagePlanes page_planes(const std::vector<PageView>& pages, const std::filesystem::path& run_folder,
                       std::size_t budget) {
    std::vector<planes::PlanesFile> files;
    for (const PageView& page : pages) {
        const ViewResult& view = *page.view;
        files.push_back({page.anchor, view.folder.empty() ? "" : run_folder / view.folder / "planes.zvp",
                         view.outcome == Outcome::defective});
    }
    const planes::EmbeddedPlanes embedded(std::move(files), {tiers, tier_of}, budget);
    json views = json::array();
    for (std::size_t i = 0; i < pages.size(); ++i) views.push_back(facts_of(pages[i], embedded, i));
    PagePlanes planes{{}, embedded.omissions()};
    planes.elements.emplace_back(
        planes::json_element("run", {{"views", std::move(views)}, {"classes", classes()}}));
    embedded.append_to(planes.elements);
    return planes;
}

}  // namespace zproof
