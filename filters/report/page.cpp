#include "filters/report/page.h"

#include <algorithm>

#include "filters/report/evidence_planes.h"
#include "filters/report/pooled.h"
#include "filters/report/table_cells.h"
#include "filters/report/tables.h"
#include "filters/study/claims.h"
#include "frame/number_text.h"
#include "frame/printable.h"
#include "reports/base64.h"
#include "reports/page_parts.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study;

constexpr std::size_t reserve_for_a_view = 20'000;  ///< for what the page says of it to the viewer

constexpr std::string_view filters_style = R"css(
.plots {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(430px, 1fr)); gap: 1rem; margin: 1.2rem 0;
}
.plots svg { display: block; width: 100%; height: auto; background: #fff; border-radius: 3px; }
.plots figure { min-width: 0; }
.chart-legend { grid-column: 1 / -1; display: flex; flex-wrap: wrap; gap: 0.3rem; }
.chart-legend button {
  font: inherit; font-size: 0.78rem; color: inherit; background: var(--soft); border: 1px solid var(--line);
  border-radius: 4px; padding: 0 0.45rem; cursor: pointer;
}
.chart-legend [aria-pressed="true"] { border-color: var(--series); box-shadow: inset 0 -3px var(--series); }
.series.away { display: none; }
.series.chosen path { stroke: var(--series); }
.series.chosen circle, .series.chosen text { fill: var(--series); }
.pointing .series:not(.lit) { opacity: 0.12; }
.series.lit path { stroke: #000; stroke-opacity: 1; }
.series.lit circle, .series.lit text { fill: #000; fill-opacity: 1; }
.crops {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(132px, 1fr)); gap: 0.9rem; margin: 1rem 0;
}
.crops img { image-rendering: pixelated; border-radius: 0; }
.crops figcaption { overflow-wrap: anywhere; }
.crops figure + figure { margin-top: 0.3rem; }
.truth { max-width: 480px; }
.scores { font-size: 0.8rem; }
.scores td, .scores th { padding-right: 0.6rem; white-space: nowrap; }
.scores td:nth-child(2) { white-space: normal; overflow-wrap: anywhere; min-width: 6.5rem; }
.best { font-weight: 600; color: var(--proven); }
.scores .open { color: var(--doubt); white-space: normal; line-height: 1.1; }
.wide + p { margin-top: 0.6rem; }
details { margin: 0.8rem 0; }
summary { cursor: pointer; color: var(--link); }
dt { font-weight: 600; }
@media (max-width: 700px) { .plots { grid-template-columns: 1fr; } }
)css";

std::string filters_headline(const StudyResults& results) {
    return counted(results.methods.size(), "texture filter") + " held to the truth in " +
           counted(results.views.size(), "view");
}

std::string opening(const StudyResults& r) {
    std::string text =
        "<header>\n<h1>" + filters_headline(r) + "</h1>\n<p>" + escaped(truth_in_words(r.truth)) + ".</p>\n";
    if (!r.is_complete)
        text +=
            "<p class=\"message\">The study was interrupted: what follows is what was done until then.</p>\n";
    return text + "<p class=\"facts\">zproof " + escaped(r.version) + " · " + escaped(r.compiler) + " · " +
           counted(std::uint64_t(r.threads), "thread") + " · " + fixed(r.seconds, 1) +
           " s</p>\n<p class=\"facts\"><code>" + escaped(r.command) + "</code></p>\n</header>\n";
}

/// A chart as elements of the page: a reader chooses among its series. HTML needs no name of SVG's space.
std::string inline_chart(const Plot& plot) {
    const std::string space = " xmlns=\"http://www.w3.org/2000/svg\"";
    std::string svg = plot.svg;
    if (const std::size_t at = svg.find(space); at != std::string::npos) svg.erase(at, space.size());
    return "<figure>" + svg + "<figcaption>" + escaped(plot.caption) + "</figcaption></figure>\n";
}

std::string plots_of(const std::vector<Plot>& plots) {
    std::string text;
    for (const Plot& plot : plots) text += inline_chart(plot);
    return "<div class=\"plots\">\n" + text + "</div>\n";
}

std::string cell_class(const TableColumn& column, const std::string& cell, bool is_best) {
    if (column.is_text) return is_best ? "best" : "";
    return cell == not_resolved ? "n open" : is_best ? "n best" : "n";
}

std::string table_of(const TableCells& table) {
    std::string heads, rows;
    for (const TableColumn& column : table.columns)
        heads += "<th" + std::string{column.is_text ? "" : " class=\"n\""} + " data-first=\"" +
                 (column.higher_is_better ? "descending" : "ascending") + "\">" + escaped(column.name) +
                 "</th>";
    for (const auto& row : table.rows) {
        const bool is_best = row.front() == "1";
        rows += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i)
            rows += "<td class=\"" + cell_class(table.columns[i], row[i], is_best && i < 2) + "\">" +
                    escaped(row[i]) + "</td>";
        rows += "</tr>\n";
    }
    return "<div class=\"wide\"><table class=\"scores sortable\"><thead><tr>" + heads +
           "</tr></thead><tbody>\n" + rows + "</tbody></table></div>\n";
}

bool has_pixels(const ViewStudy& view, const std::string& region) {
    if (view.methods.empty()) return false;
    const RegionScore* const score = find_score(view.methods.front(), region);
    return score != nullptr && score->pixels > 0;
}

/// The interior in full; every other region folded away.
std::string tables_of(const StudyResults& results, const ViewStudy& view) {
    std::string text;
    for (const RegionCard& region : results.regions) {
        if (!has_pixels(view, region.name)) continue;
        const TableCells table = table_cells(results, view, {region.name});
        const bool is_main = region.name == "interior";
        const std::string whole = "<summary>" + escaped(table.title.substr(table.title.find("region"))) +
                                  ": " + escaped(region.definition) + "</summary>" + table_of(table);
        text += "<details" + std::string{is_main ? " open" : ""} + ">" + whole + "</details>\n";
    }
    return text;
}

std::string left_out_of(const PooledScores& pool) {
    std::string text;
    for (const std::string& line : left_out_in_words(pool)) text += "<p>" + escaped(line) + "</p>\n";
    return text;
}

std::string crops_of(const ViewFigures& figures) {
    std::string text;
    for (const PageImage& crop : figures.crops)
        text += "<div>" + page_figure(crop.data, crop.caption, in_words(figures.crop)) +
                (crop.error.empty() ? "" : page_figure(crop.error, "error", in_words(figures.crop))) +
                "</div>\n";
    return "<h3>Pixels " + in_words(figures.crop) +
           " (x, y, width, height)</h3>\n<p class=\"facts\">Below each crop, the error of its worst channel: "
           "dark "
           "for 1/1024 and less, yellow for 1; equal ratios lie equally far apart.</p>\n<div "
           "class=\"crops\">\n" +
           text + "</div>\n";
}

std::string anchor_of(std::size_t i) { return "view-" + std::to_string(i + 1); }

std::string section_of(const StudyResults& results, const ViewStudy& view, const std::string& anchor,
                       const ViewFigures& figures) {
    std::string text = "<section id=\"" + anchor + "\">\n<h2>" + escaped(view.scene) +
                       " <span class=\"view\">" + escaped(view.view) + "</span></h2>\n";
    if (!view.reason.empty()) text += "<p class=\"reason\">" + escaped(view.reason) + "</p>\n";
    text += "<p class=\"facts\">" + size_text(view.width, view.height) + " pixels · texture " +
            escaped(view.textures) + " · truth in " + fixed(view.truth_seconds, 2) + " s</p>\n";
    for (const MissingPicture& one : view.missing)
        text += "<p class=\"reason\"><strong>" + escaped(one.label) +
                "</strong> has no picture of this view: " + escaped(one.reason) + "</p>\n";
    for (const MethodScore& method : view.methods)
        if (method.claim) text += "<p class=\"reason\">" + escaped(claim_words(method)) + "</p>\n";
    return text + "<div class=\"truth\">" + page_figure(figures.truth.data, figures.truth.caption) +
           "</div>\n" + tables_of(results, view) + crops_of(figures) + plots_of(figures.plots) +
           "</section>\n";
}

std::string pools_of(const StudyResults& results, const std::vector<PooledScores>& pools) {
    std::string text;
    for (const PooledScores& pool : pools) {
        const TableCells table = pooled_cells(results, pool);
        text += "<details" + std::string{text.empty() ? " open" : ""} + "><summary>" + escaped(table.title) +
                "</summary>" + table_of(table) + left_out_of(pool) + "</details>\n";
    }
    if (pools.empty()) return text;
    return text + "<p>Intervals are 95 % by bootstrap over textures (" +
           std::to_string(pools[0].choice.samples) + " samples, seed " +
           std::to_string(pools[0].choice.seed) +
           "). First: in how many of the samples the method is the best. The last two columns are paired, "
           "texture by "
           "texture.</p>\n";
}

std::string definition(const std::string& name, const std::string& words) {
    return "<dt>" + escaped(name) + "</dt><dd>" + escaped(words) + "</dd>\n";
}

std::string legend(const StudyResults& results) {
    std::string metrics, methods;
    for (const MetricCard& m : results.metrics)
        metrics += definition(m.name, m.definition + (m.source.empty() ? "" : " (" + m.source + ")"));
    metrics += definition("flicker",
                          "RMS of what changes from view to view, each a fraction of a pixel further, and "
                          "does not change in the truth; ratio: RMS change over that of the truth.");
    metrics +=
        definition("texels, lines", "Stored values read per pixel; distinct 64-byte lines that hold them.");
    metrics += definition("stored, build ms, ns",
                          "Memory of what the method keeps; time to make it; time of a "
                          "lookup on one thread.");
    for (const MethodCard& m : results.methods)
        methods +=
            definition(m.label, m.footprint + " LOD: " + m.lod + " Taps: " + m.taps + " (" + m.source + ")");
    return "<section class=\"legend\">\n<h2>How to read this</h2>\n<p>Metrics are in linear light, 0 black, "
           "1 white. "
           "Methods of one rank cannot be told apart: the truth is not known to a fifth of what lies between "
           "them. "
           "<em>not resolved</em>: nor to a fifth of the method's own error.</p>\n<div "
           "class=\"columns\"><div>"
           "<h3>Metrics</h3><dl>" +
           metrics + "</dl></div><div><h3>Methods</h3><dl>" + methods + "</dl></div></div>\n</section>\n";
}

std::vector<planes::PlanesFile> planes_files(const StudyResults& results,
                                             const std::filesystem::path& folder) {
    std::vector<planes::PlanesFile> files;
    for (std::size_t i = 0; i < results.views.size(); ++i)
        files.push_back({anchor_of(i), folder / view_folder(results.views[i]) / "planes.zvp"});
    return files;
}

/// What the viewer must know before it decodes a view.
nlohmann::json study_facts(const StudyResults& results, const planes::EmbeddedPlanes& embedded) {
    nlohmann::json views = nlohmann::json::array(), regions = nlohmann::json::array();
    for (std::size_t i = 0; i < results.views.size(); ++i) {
        const ViewStudy& view = results.views[i];
        views.push_back({{"anchor", anchor_of(i)},
                         {"link", view_folder(view).filename().string()},
                         {"folder", view_folder(view).string()},
                         {"scene", one_line(view.scene)},
                         {"view", one_line(view.view)},
                         {"message", ""},
                         {"width", view.width},
                         {"height", view.height},
                         {"planes", embedded.has_planes(i)}});
    }
    for (const RegionCard& region : results.regions)
        regions.push_back({{"name", region.name}, {"definition", region.definition}});
    return {{"truth", results.truth}, {"regions", std::move(regions)}, {"views", std::move(views)}};
}

}  // namespace

std::filesystem::path view_folder(const ViewStudy& view) {
    return std::filesystem::path{view.truth_file}.parent_path();
}

StudyPage filters_page(const StudyResults& results, const StudyFigures& figures,
                       const std::filesystem::path& folder, std::size_t budget) {
    PageScript script = viewer_script();
    script.loads_others = true;
    std::string begin = page_head(filters_headline(results),
                                  std::string{filters_style} + std::string{viewer_style()}, script) +
                        "<body>\n" + opening(results),
                sections = "<main>\n";
    if (!figures.overview.empty())
        sections += "<section>\n<h2>All views together</h2>\n" + pools_of(results, figures.pools) +
                    plots_of(figures.overview) + "</section>\n";
    for (std::size_t i = 0; i < results.views.size(); ++i)
        sections += section_of(results, results.views[i], anchor_of(i), figures.views.at(i));
    sections += legend(results) + "</main>\n";
    const std::string end = page_end(script);
    const std::size_t spent =
        begin.size() + sections.size() + end.size() + (1 + results.views.size()) * reserve_for_a_view;
    const planes::EmbeddedPlanes embedded(planes_files(results, folder), evidence_tiers(),
                                          budget > spent ? budget - spent : 0);
    Page page{std::move(begin), embedded.omissions(), std::move(sections),
              planes::json_element("study", study_facts(results, embedded))};
    embedded.append_to(page);
    page.emplace_back(end);
    return {std::move(page), embedded.scripts()};
}

}  // namespace zproof
