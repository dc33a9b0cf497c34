#include "reports/filters/table_cells.h"

#include <cmath>

#include "reports/wording.h"
#include "study/filters/claims.h"

namespace zproof {

namespace {

using namespace study;

std::string cell(double value, int decimals) {
    if (std::isnan(value)) return "-";
    return std::isinf(value) ? shortest(value) : fixed(value, decimals);
}

/// RMSE and PSNR are claims about the truth; both stand or fall together.
bool is_claim(const MetricCard& metric) { return metric.name == "rmse" || metric.name == "psnr"; }

void add_metrics(const StudyResults& results, const RegionScore& score, std::vector<std::string>& row) {
    for (std::size_t i = 0; i < results.metrics.size(); ++i) {
        const MetricCard& metric = results.metrics[i];
        const bool is_open = is_claim(metric) && !is_resolved(results, score);
        row.push_back(is_open ? std::string{not_resolved} : cell(score.values.at(i), metric.decimals));
    }
}

void add_costs(const MethodScore& method, std::vector<std::string>& row) {
    const bool has_flicker = method.flicker.steps > 0;
    row.push_back(has_flicker ? cell(method.flicker.rms, 4) : "-");
    row.push_back(has_flicker ? cell(method.flicker.ratio, 2) : "-");
    row.push_back(cell(method.cost.texels, 1));
    row.push_back(cell(method.cost.lines, 1));
    row.push_back(bytes_in_words(method.cost.bytes_stored));
    row.push_back(cell(method.cost.build_ms, 1));
    row.push_back(cell(method.cost.ns_per_sample, 0));
}

/// Cost and flicker are of the whole picture: they stand beside the regions that are quoted, and are no value
/// of a smaller one.
bool shows_costs(const std::string& region) { return region == "all" || region == "interior"; }

std::vector<TableColumn> columns_of(const StudyResults& results, const std::string& region) {
    std::vector<TableColumn> columns{{"rank"}, {"method", true}};
    for (const MetricCard& metric : results.metrics)
        columns.push_back({metric.name, false, metric.higher_is_better});
    if (!shows_costs(region)) return columns;
    for (const char* name : {"flicker", "ratio", "texels", "lines", "stored", "build ms", "ns"})
        columns.push_back({name});
    return columns;
}

}  // namespace

TableCells table_cells(const StudyResults& results, const ViewStudy& view, const std::string& region) {
    TableCells table{
        .title = view.scene + " / " + view.view, .columns = columns_of(results, region), .rows = {}};
    const std::vector<int> places = ranks(results, view, region);
    std::uint64_t pixels = 0;
    for (std::size_t i = 0; i < view.methods.size(); ++i) {
        const RegionScore* const score = find_score(view.methods[i], region);
        if (score == nullptr) continue;
        pixels = score->pixels;
        table.rows.push_back({places[i] == 0 ? "-" : std::to_string(places[i]), view.methods[i].label});
        add_metrics(results, *score, table.rows.back());
        if (shows_costs(region)) add_costs(view.methods[i], table.rows.back());
    }
    if (view.first_row > 0) table.title += ", rows from " + std::to_string(view.first_row);
    table.title += ", " + std::to_string(view.width) + " x " + std::to_string(view.height) + ", region '" +
                   region + "' (" + counted(pixels, "pixel") + "), GT-" + results.truth;
    return table;
}

std::string truth_in_words(const std::string& truth) {
    if (truth == "N")
        return "GT-N: the exact mean, over the pixel's square in screen space, of the texture as squares of "
               "one "
               "colour";
    if (truth == "B")
        return "GT-B: the exact mean, over the pixel's square in screen space, of the bilinearly "
               "interpolated "
               "texture";
    return "GT-G: the mean under a Gaussian of radius 1 pixel, in screen space, of the bilinearly "
           "interpolated "
           "texture";
}

std::string bytes_in_words(std::uint64_t bytes) {
    constexpr std::uint64_t kib = 1024, mib = 1024 * kib;
    if (bytes < kib) return std::to_string(bytes) + " B";
    if (bytes < mib) return fixed(double(bytes) / double(kib), 1) + " KiB";
    return fixed(double(bytes) / double(mib), 1) + " MiB";
}

}  // namespace zproof
