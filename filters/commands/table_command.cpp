#include <iostream>

#include "filters/commands/commands.h"
#include "filters/report/folder.h"
#include "filters/report/pooled.h"
#include "filters/report/tables.h"
#include "frame/printable.h"
#include "program/nearest_word.h"

namespace zproof {
namespace {

using study::StudyResults;

void require_one_of(const std::vector<std::string>& names, const std::string& word, const std::string& what) {
    require_known(word, {.words = names, .place = "--" + what, .kind = what});
}

template <class Card>
std::vector<std::string> names_of(const std::vector<Card>& cards, std::string Card::*name) {
    std::vector<std::string> names;
    for (const Card& card : cards) names.push_back(card.*name);
    return names;
}

void require_what_was_studied(const StudyResults& results, const FiltersTableArguments& arguments) {
    const TableChoice& choice = arguments.choice;
    require_one_of(names_of(results.regions, &study::RegionCard::name), choice.region, "region");
    const std::vector<std::string> columns =
        arguments.is_pooled ? names_of(results.metrics, &study::MetricCard::name) : column_names(results);
    for (const std::string& column : choice.columns) require_one_of(columns, column, "columns");
    if (!choice.sort.empty()) require_one_of(columns, choice.sort, "sort");
}

std::vector<study::PooledScores> pools_of(const StudyResults& results,
                                          const FiltersTableArguments& arguments) {
    std::vector<std::string> metrics = arguments.choice.columns;
    if (metrics.empty()) metrics = {"psnr", "flip"};
    std::vector<study::PooledScores> pools;
    for (const std::string& metric : metrics)
        pools.push_back(study::pooled(results, {.metric = metric, .region = arguments.choice.region}));
    if (arguments.baseline.empty()) return pools;
    for (study::PooledScores& pool : pools) {
        require_one_of(names_of(pool.methods, &study::PooledMethod::label), arguments.baseline, "baseline");
        pool.choice.baseline = arguments.baseline;
        pool = study::pooled(results, pool.choice);
    }
    return pools;
}

ExitCode print_pooled(const StudyResults& results, const FiltersTableArguments& arguments) {
    if (arguments.format == TableFormat::csv) {
        std::cout << pooled_csv(results, arguments.choice.region);
        return ExitCode::proven;
    }
    const char* gap = "";
    for (const study::PooledScores& pool : pools_of(results, arguments)) {
        const TableCells cells = pooled_cells(results, pool);
        std::cout << gap
                  << (arguments.format == TableFormat::latex ? latex_table(cells) : terminal_table(cells));
        for (const std::string& line : left_out_in_words(pool))
            if (arguments.format == TableFormat::terminal) std::cout << one_line(line) << "\n";
        gap = "\n";
    }
    return ExitCode::proven;
}

}  // namespace

ExitCode execute(const FiltersTableArguments& arguments) {
    const StudyResults results = read_filters_results(arguments.folder);
    require_what_was_studied(results, arguments);
    if (arguments.is_pooled) return print_pooled(results, arguments);
    if (arguments.format == TableFormat::csv) std::cout << filters_csv(results);
    if (arguments.format == TableFormat::latex) std::cout << filters_latex(results, arguments.choice);
    if (arguments.format == TableFormat::terminal) std::cout << filters_table(results, arguments.choice);
    return ExitCode::proven;
}

}  // namespace zproof
