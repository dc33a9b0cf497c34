#include "filters/report/table_cells.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>

#include "filters/study/claims.h"
#include "frame/number_text.h"
#include "reports/wording.h"

namespace zproof {

namespace {

using namespace study;

std::string cell(double value, int decimals) {
    if (std::isnan(value)) return "-";
    return std::isinf(value) ? shortest(value) : fixed(value, decimals);
}

/// RMSE and PSNR are claims about the truth; both stand or fall together.
bool is_claim(const MetricCard& metric) { return metric.name == "rmse" || metric.name == "psnr"; }

/// A column beside rank and method.
struct ColumnRule {
    std::string name;
    bool higher_is_better = false;
    std::function<double(const MethodScore&, const RegionScore&)> value;
    std::function<std::string(const MethodScore&, const RegionScore&)> text;
};

ColumnRule metric_rule(const StudyResults& results, std::size_t i) {
    const MetricCard& metric = results.metrics[i];
    const auto value = [i](const MethodScore&, const RegionScore& score) { return score.values.at(i); };
    const auto text = [&results, &metric, i](const MethodScore&, const RegionScore& score) {
        const bool is_open = is_claim(metric) && !is_resolved(results, score);
        return is_open ? std::string{not_resolved} : cell(score.values.at(i), metric.decimals);
    };
    return {metric.name, metric.higher_is_better, value, text};
}

ColumnRule rule_of(const std::string& name, double Cost::*part, int decimals) {
    const auto value = [part](const MethodScore& m, const RegionScore&) { return m.cost.*part; };
    return {name, false, value,
            [=](const MethodScore& m, const RegionScore& score) { return cell(value(m, score), decimals); }};
}

ColumnRule rule_of(const std::string& name, double Flicker::*part, int decimals) {
    const auto value = [part](const MethodScore& m, const RegionScore&) {
        return m.flicker.steps > 0 ? m.flicker.*part : std::numeric_limits<double>::quiet_NaN();
    };
    return {name, false, value,
            [=](const MethodScore& m, const RegionScore& score) { return cell(value(m, score), decimals); }};
}

/// It is unknown for pictures of others, as what they read is.
ColumnRule stored_rule() {
    const auto value = [](const MethodScore& m, const RegionScore&) {
        return std::isnan(m.cost.texels) ? m.cost.texels : double(m.cost.bytes_stored);
    };
    return {"stored", false, value, [=](const MethodScore& m, const RegionScore& score) {
                return std::isnan(value(m, score)) ? "-" : bytes_in_words(m.cost.bytes_stored);
            }};
}

/// Cost and flicker are of the whole picture: they stand beside the regions that are quoted, and are no value
/// of a smaller one.
bool shows_costs(const std::string& region) { return region == "all" || region == "interior"; }

std::vector<ColumnRule> all_columns(const StudyResults& results, const std::string& region) {
    std::vector<ColumnRule> rules;
    for (std::size_t i = 0; i < results.metrics.size(); ++i) rules.push_back(metric_rule(results, i));
    if (!shows_costs(region)) return rules;
    rules.insert(rules.end(),
                 {rule_of("flicker", &Flicker::rms, 4), rule_of("ratio", &Flicker::ratio, 2),
                  rule_of("texels", &Cost::texels, 1), rule_of("lines", &Cost::lines, 1), stored_rule(),
                  rule_of("build ms", &Cost::build_ms, 1), rule_of("ns", &Cost::ns_per_sample, 0)});
    return rules;
}

std::vector<ColumnRule> chosen_columns(const StudyResults& results, const TableChoice& choice) {
    const std::vector<ColumnRule> all = all_columns(results, choice.region);
    if (choice.columns.empty()) return all;
    std::vector<ColumnRule> chosen;
    for (const std::string& name : choice.columns)
        std::ranges::copy_if(all, std::back_inserter(chosen),
                             [&](const ColumnRule& r) { return r.name == name; });
    return chosen;
}

/// A row in the making.
struct ScoredMethod {
    const MethodScore* method;
    const RegionScore* score;
    int rank;
};

/// What is no number comes last.
void sort_by(const ColumnRule& rule, std::vector<ScoredMethod>& rows) {
    std::ranges::stable_sort(rows, {}, [&](const ScoredMethod& row) {
        const double value = rule.value(*row.method, *row.score);
        if (std::isnan(value)) return std::numeric_limits<double>::infinity();
        return rule.higher_is_better ? -value : value;
    });
}

std::vector<ScoredMethod> scored_methods(const StudyResults& results, const ViewStudy& view,
                                         const TableChoice& choice) {
    const std::vector<int> places = ranks(results, view, choice.region);
    std::vector<ScoredMethod> rows;
    for (std::size_t i = 0; i < view.methods.size(); ++i)
        if (const RegionScore* const score = find_score(view.methods[i], choice.region))
            rows.push_back({&view.methods[i], score, places[i]});
    for (const ColumnRule& rule : all_columns(results, choice.region))
        if (rule.name == choice.sort) sort_by(rule, rows);
    return rows;
}

}  // namespace

std::vector<std::string> column_names(const StudyResults& results) {
    std::vector<std::string> names;
    for (const ColumnRule& rule : all_columns(results, "interior")) names.push_back(rule.name);
    return names;
}

TableCells table_cells(const StudyResults& results, const ViewStudy& view, const TableChoice& choice) {
    TableCells table{
        .title = view.scene + " / " + view.view, .columns = {{"rank"}, {"method", true}}, .rows = {}};
    const std::vector<ColumnRule> rules = chosen_columns(results, choice);
    for (const ColumnRule& rule : rules) table.columns.push_back({rule.name, false, rule.higher_is_better});
    std::uint64_t pixels = 0;
    for (const auto& [method, score, rank] : scored_methods(results, view, choice)) {
        pixels = score->pixels;
        table.rows.push_back({rank == 0 ? "-" : std::to_string(rank), method->label});
        for (const ColumnRule& rule : rules) table.rows.back().push_back(rule.text(*method, *score));
    }
    if (view.first_row > 0) table.title += ", rows from " + std::to_string(view.first_row);
    table.title += ", " + size_text(view.width, view.height) + ", region '" + choice.region + "' (" +
                   counted(pixels, "pixel") + "), GT-" + results.truth;
    return table;
}

std::string truth_in_words(const std::string& truth) {
    const std::string bilinear = ", in screen space, of the bilinearly interpolated texture",
                      nearest = ", in screen space, of the texture as squares of one colour",
                      gaussian = ": the mean under a Gaussian of radius 1 pixel";
    const std::map<std::string, std::string> words{
        {"N", ": the exact mean, over the pixel's square" + nearest},
        {"B", ": the exact mean, over the pixel's square" + bilinear},
        {"G", gaussian + bilinear},
        {"GN", gaussian + nearest},
        {"M", ": the mean under Mitchell and Netravali's filter of radius 2 pixels" + bilinear},
        {"BH", ": the mean under the Blackman-Harris filter of 3 x 3 pixels" + bilinear},
    };
    const auto found = words.find(truth);
    return "GT-" + truth + (found == words.end() ? "" : found->second);
}

std::string bytes_in_words(std::uint64_t bytes) {
    constexpr std::uint64_t kib = 1024, mib = 1024 * kib;
    if (bytes < kib) return std::to_string(bytes) + " B";
    if (bytes < mib) return fixed(double(bytes) / double(kib), 1) + " KiB";
    return fixed(double(bytes) / double(mib), 1) + " MiB";
}

}  // namespace zproof
