#include <functional>
#include <nlohmann/json.hpp>

#include "reports/base64.h"
#include "reports/html_parts.h"
#include "reports/planes/deflate.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using nlohmann::json;

/// So many that packing finds what they have in common, and so few that one is unpacked at once.
constexpr std::size_t facts_in_pack = 1000;

/// What the packs of some views are named and hold.
struct PackKind {
    std::string id;
    std::size_t views;
    std::function<std::string(std::span<const PageView>)> text;
};

std::string element(const std::string& id, std::string_view content) {
    return "<script type=\"application/zlib\" id=\"" + id + "\">" + base64(content) + "</script>\n";
}

/// Packs as long as there is room.
PackedViews packed(std::span<const PageView> views, const PackKind& kind, std::size_t budget) {
    PackedViews packs;
    Deflater deflater;
    while (packs.views < views.size()) {
        const std::span<const PageView> rest = views.subspan(packs.views),
                                        some = rest.first(std::min(rest.size(), kind.views));
        std::string text = element(kind.id + "-" + std::to_string(packs.elements.size()),
                                   deflater.deflated(kind.text(some)));
        if (packs.bytes + text.size() > budget) break;
        packs.bytes += text.size();
        packs.views += some.size();
        packs.elements.push_back(std::move(text));
    }
    return packs;
}

/// The texts of its row, a tab between two; empty where it was not judged.
std::string row_of(const ViewResult& v) {
    if (!was_judged(v)) return "";
    std::string row;
    for (const std::string& text : summary_texts(v)) row += (row.empty() ? "" : "\t") + text;
    return row;
}

/// The name by which links mean a view: the last part of its folder, unique within a run.
std::string link_name(const ViewResult& view) { return view.folder.substr(view.folder.rfind('/') + 1); }

/// What the page says of a view to its script, in the order of fact_names().
json facts_of(const PageView& page) {
    const ViewResult& v = *page.view;
    return {link_name(v),
            v.folder,
            one_line(v.scene),
            one_line(v.view),
            one_line(v.source),
            name_of(v.outcome),
            one_line(v.message),
            one_line(v.candidate),
            one_line(v.reference),
            v.width,
            v.height,
            v.triangles,
            v.counts,
            v.diagnosis && v.diagnosis->cause ? one_line(v.diagnosis->cause->name) : "",
            page.has_planes,
            row_of(v),
            fixed(seconds(v.times), 2)};
}

/// ASCII alone: a browser keeps it in half the memory.
std::string facts_of_all(std::span<const PageView> views) {
    std::string text = "[";
    for (const PageView& view : views)
        text += (text.size() == 1 ? "" : ",") +
                facts_of(view).dump(-1, ' ', true, json::error_handler_t::replace);
    return text + "]";
}

std::string sections_of_all(std::span<const PageView> views) {
    std::string text;
    for (const PageView& view : views) text += html_view(view);
    return text;
}

}  // namespace

std::vector<std::string> fact_names() {
    return {"link",    "folder",    "scene",     "view",  "source", "outcome",
            "message", "candidate", "reference", "width", "height", "triangles",
            "counts",  "cause",     "planes",    "row",   "seconds"};
}

PackedViews packed_facts(std::span<const PageView> views, std::size_t budget) {
    return packed(views, {"facts", facts_in_pack, facts_of_all}, budget);
}

PackedViews packed_pictures(std::span<const PageView> views, const std::filesystem::path& run_folder,
                            std::size_t budget) {
    const auto pictures = [&](std::span<const PageView> some) {
        json all = json::array();
        for (const PageView& view : some) all.push_back(card_picture_of(*view.view, run_folder));
        return all.dump();
    };
    return packed(views, {"pictures", sections_in_pack, pictures}, budget);
}

PackedViews packed_sections(std::span<const PageView> views, std::size_t budget) {
    return packed(views, {"sections", sections_in_pack, sections_of_all}, budget);
}

}  // namespace zproof
