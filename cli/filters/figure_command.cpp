#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/nearest_word.h"
#include "cli/usage_error.h"
#include "frame/printable.h"
#include "reports/filters/folder.h"

namespace zproof {
namespace {

void require_methods(const study::StudyResults& results, const std::vector<std::string>& labels) {
    std::vector<std::string> known;
    for (const study::MethodCard& card : results.methods) known.push_back(card.label);
    for (const std::string& label : labels)
        if (std::ranges::find(known, label) == known.end())
            throw UsageError{"--methods: '" + label + "' is not in this study" + did_you_mean(label, known) +
                             " (zproof filters table shows what is)"};
}

}  // namespace

ExitCode execute(const FiltersFigureArguments& arguments) {
    const study::StudyResults results = read_filters_results(arguments.folder);
    require_methods(results, arguments.labels);
    write_filters_figures(arguments.folder, results, {arguments.labels, arguments.crop});
    std::cout << one_line((arguments.folder / "filters.html").string()) << "\n";
    return ExitCode::proven;
}

}  // namespace zproof
