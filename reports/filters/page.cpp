#include "reports/filters/page.h"

#include <algorithm>

#include "reports/base64.h"
#include "reports/filters/pooled.h"
#include "reports/filters/table_cells.h"
#include "reports/page_parts.h"
#include "reports/wording.h"
#include "study/filters/claims.h"

namespace zproof {

namespace {

using namespace study;

constexpr std::string_view filters_style = R"css(
.plots {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(430px, 1fr)); gap: 1rem; margin: 1.2rem 0;
}
.plots img { background: #fff; image-rendering: auto; }
.crops {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(132px, 1fr)); gap: 0.9rem; margin: 1rem 0;
}
.crops img { image-rendering: pixelated; border-radius: 0; }
.crops figcaption { overflow-wrap: anywhere; }
.truth { max-width: 480px; }
.scores { font-size: 0.86rem; }
.scores td, .scores th { padding-right: 0.65rem; white-space: nowrap; }
.best { font-weight: 600; color: var(--proven); }
.open { color: var(--doubt); }
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

std::string svg_uri(const std::string& svg) { return "data:image/svg+xml;base64," + base64(svg); }

std::string plots_of(const std::vector<Plot>& plots) {
    std::string text;
    for (const Plot& plot : plots) text += page_figure(svg_uri(plot.svg), plot.caption);
    return "<div class=\"plots\">\n" + text + "</div>\n";
}

std::string cell_class(const TableColumn& column, const std::string& cell, bool is_best) {
    if (column.is_text) return is_best ? "best" : "";
    return cell == not_resolved ? "n open" : is_best ? "n best" : "n";
}

std::string table_of(const TableCells& table) {
    std::string heads, rows;
    for (const TableColumn& column : table.columns)
        heads +=
            "<th" + std::string{column.is_text ? "" : " class=\"n\""} + ">" + escaped(column.name) + "</th>";
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
        text += page_figure(crop.data, crop.caption, in_words(figures.crop));
    return "<h3>Pixels " + in_words(figures.crop) + " (x, y, width, height)</h3>\n<div class=\"crops\">\n" +
           text + "</div>\n";
}

std::string section_of(const StudyResults& results, const ViewStudy& view, const ViewFigures& figures) {
    std::string text = "<section>\n<h2>" + escaped(view.scene) + " <span class=\"view\">" +
                       escaped(view.view) + "</span></h2>\n";
    if (!view.reason.empty()) text += "<p class=\"reason\">" + escaped(view.reason) + "</p>\n";
    text += "<p class=\"facts\">" + std::to_string(view.width) + " x " + std::to_string(view.height) +
            " pixels · texture " + escaped(view.textures) + " · truth in " + fixed(view.truth_seconds, 2) +
            " s</p>\n";
    for (const MissingPicture& one : view.missing)
        text += "<p class=\"reason\"><strong>" + escaped(one.label) +
                "</strong> has no picture of this view: " + escaped(one.reason) + "</p>\n";
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

}  // namespace

std::string filters_page(const StudyResults& results, const std::vector<ViewFigures>& figures,
                         const StudyOverview& overview) {
    std::string page =
        page_head(filters_headline(results), filters_style) + "<body>\n" + opening(results) + "<main>\n";
    if (!overview.plots.empty())
        page += "<section>\n<h2>All views together</h2>\n" + pools_of(results, overview.pools) +
                plots_of(overview.plots) + "</section>\n";
    for (std::size_t i = 0; i < results.views.size(); ++i)
        page += section_of(results, results.views[i], figures.at(i));
    return page + legend(results) + "</main>\n" + page_end();
}

}  // namespace zproof
