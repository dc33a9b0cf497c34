#include <algorithm>
#include <cmath>
#include <iostream>

#include "filters/commands/commands.h"
#include "filters/report/tables.h"
#include "filters/study/published_results.h"
#include "frame/number_text.h"
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
double rounded_to(double value, int decimals) {
    const double scale = std::pow(10, decimals), whole = std::round(value * scale);
    return whole == 0 ? 0 : whole / scale;
}

std::string word_for(const PublishedFigure& figure) {
    switch (figure.as) {
        case study::PublishedAs::measurement:
        case study::PublishedAs::measurement_elsewhere:
            return "measurement";
        case study::PublishedAs::identity:
            return "identity";
        case study::PublishedAs::expectation:
            return "expectation, +- " + rounded(figure.standard_error);
    }
    return "";
}

std::string table_of(const PublishedResult& result, const std::vector<PublishedFigure>& figures) {
    TableCells table{.title = std::string{result.name} + ": " + std::string{result.sentence} + "\n(" +
                              std::string{result.source} + ")",
                     .columns = {{"figure", true},
                                 {"published"},
                                 {"ours"},
                                 {"difference"},
                                 {"unit", true},
                                 {"published as", true},
                                 {"verdict", true}},
                     .rows = {}};
    for (const PublishedFigure& f : figures)
        table.rows.push_back({f.what, fixed(f.published, f.decimals), fixed(f.ours, f.decimals),
                              fixed(rounded_to(f.ours - f.published, f.decimals), f.decimals), f.unit,
                              word_for(f), verdict_on(f)});
    return terminal_table(table);
}

}  // namespace

ExitCode execute(const FiltersReproduceArguments& arguments) {
    const std::vector<std::string> known = names_of_results();
    for (const std::string& name : arguments.names)
        require_known(name, {.words = known, .place = "filters reproduce:", .kind = "result"});
    const char* gap = "";
    bool is_refuted = false;
    for (const PublishedResult& result : study::published_results()) {
        if (!arguments.names.empty() &&
            std::ranges::find(arguments.names, result.name) == arguments.names.end())
            continue;
        std::vector<PublishedFigure> figures;
        on_threads(arguments.common.threads, [&] { figures = result.figures(); });
        std::cout << gap << table_of(result, figures) << std::flush;
        gap = "\n";
        is_refuted |= std::ranges::any_of(
            figures, [](const PublishedFigure& figure) { return is_confirmed(figure) == false; });
    }
    return is_refuted ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
