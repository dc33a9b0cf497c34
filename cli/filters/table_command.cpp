#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/nearest_word.h"
#include "cli/usage_error.h"
#include "reports/filters/folder.h"
#include "reports/filters/tables.h"

namespace zproof {
namespace {

void require_region(const study::StudyResults& results, const std::string& region) {
    std::vector<std::string> names;
    for (const study::RegionCard& card : results.regions) names.push_back(card.name);
    if (std::ranges::find(names, region) != names.end()) return;
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw UsageError{"--region '" + region + "': no such region" + did_you_mean(region, names) +
                     " (known: " + list + ")"};
}

}  // namespace

ExitCode execute(const FiltersTableArguments& arguments) {
    const study::StudyResults results = read_filters_results(arguments.folder);
    require_region(results, arguments.region);
    if (arguments.format == TableFormat::csv) std::cout << filters_csv(results);
    if (arguments.format == TableFormat::latex) std::cout << filters_latex(results, arguments.region);
    if (arguments.format == TableFormat::terminal) std::cout << filters_table(results, arguments.region);
    return ExitCode::proven;
}

}  // namespace zproof
