#include <algorithm>
#include <cmath>
#include <iostream>

#include "filters/commands/commands.h"
#include "filters/report/tables.h"
#include "filters/study/published_results.h"
#include "program/common_arguments.h"
#include "program/nearest_word.h"
#include "reports/wording.h"

namespace zproof {
namespace {

using study::PublishedFigure;
using study::PublishedResult;

std::vector<std::string> names_of_results() {
    std::vector<std::string> names;
    for (const PublishedResult& result : study::published_results()) names.emplace_back(result.name);
    return names;
}

/// As it is shown: no "-0.00".
double rounded(double value, int decimals) {
    const double scale = std::pow(10, decimals), whole = std::round(value * scale);
    return whole == 0 ? 0 : whole / scale;
}

std::string table_of(const PublishedResult& result) {
    TableCells table{.title = std::string{result.name} + ": " + std::string{result.sentence} + "\n(" +
                              std::string{result.source} + ")",
                     .columns = {{"figure", true}, {"published"}, {"ours"}, {"difference"}, {"unit", true}},
                     .rows = {}};
    for (const PublishedFigure& f : result.figures())
        table.rows.push_back({f.what, fixed(f.published, f.decimals), fixed(f.ours, f.decimals),
                              fixed(rounded(f.ours - f.published, f.decimals), f.decimals), f.unit});
    return terminal_table(table);
}

}  // namespace

ExitCode execute(const FiltersReproduceArguments& arguments) {
    const std::vector<std::string> known = names_of_results();
    for (const std::string& name : arguments.names)
        require_known(name, {.words = known, .place = "filters reproduce:", .kind = "result"});
    const char* gap = "";
    for (const PublishedResult& result : study::published_results()) {
        if (!arguments.names.empty() &&
            std::ranges::find(arguments.names, result.name) == arguments.names.end())
            continue;
        std::string table;
        on_threads(arguments.common.threads, [&] { table = table_of(result); });
        std::cout << gap << table << std::flush;
        gap = "\n";
    }
    return ExitCode::proven;
}

}  // namespace zproof
