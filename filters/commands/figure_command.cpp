#include <algorithm>
#include <iostream>

#include "filters/commands/commands.h"
#include "filters/report/folder.h"
#include "frame/printable.h"
#include "program/nearest_word.h"
#include "program/publish.h"
#include "program/usage_error.h"
#include "reports/output_folder.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

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
    const FigureChoice choice{arguments.labels, arguments.crop};
    fs::path place = arguments.folder;
    if (arguments.common.out.empty()) {
        write_filters_figures({.study = place, .figures = place}, results, choice);
    } else {
        OutputFolder out{arguments.common.out};
        write_filters_figures({.study = place, .figures = out.working()}, results, choice);
        place = publish(out, arguments.common);
    }
    std::cout << one_line((place / "filters.html").string()) << "\n";
    return ExitCode::proven;
}

}  // namespace zproof
