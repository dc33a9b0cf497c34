#include <algorithm>
#include <filesystem>
#include <iostream>

#include "cli/commands.h"
#include "frame/input_file.h"
#include "frame/number_text.h"
#include "frame/printable.h"
#include "frame/whole_file.h"
#include "reports/findings_file.h"
#include "reports/report_error.h"
#include "reports/results_diff.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// What is known of a view's defects: a view without a defect needs no file to say so.
DefectList defects_of(const ViewResult& view, const fs::path& run_folder) {
    if (!was_judged(view)) return std::nullopt;
    if (defect_count(view) == 0) return std::vector<DefectPixel>{};
    const fs::path file = run_folder / view.folder / "findings.csv";
    if (view.folder.empty() || !fault_of_input(file).empty()) return std::nullopt;
    return defects_among(findings_from_csv(content_of(file), file.string()));
}

RunToCompare with_defects(const Results& results, const fs::path& run_folder) {
    RunToCompare run{results, {}};
    for (const ViewResult& view : results.views) run.defects.push_back(defects_of(view, run_folder));
    return run;
}

std::string size_of(const ViewResult& view) { return size_text(view.width, view.height); }

/// Pixels of two sizes are not the same pixels.
void require_one_size(const std::vector<ViewChange>& changes) {
    for (const auto& [scene, view, before, after, appeared, gone] : changes) {
        if (before == nullptr || after == nullptr || !was_judged(*before) || !was_judged(*after)) continue;
        if (size_of(*before) != size_of(*after))
            throw ReportError{scene + "/" + view + ": was judged at " + size_of(*before) + " and then at " +
                              size_of(*after) + "; judge both at the same --width and --height"};
    }
}

std::string told(const DiffResultsArguments& arguments, const Results& before, const Results& after,
                 const std::vector<ViewChange>& changes) {
    if (arguments.format == DifferenceFormat::json) return differences_json(before, after, changes);
    const std::string table = differences_table(before, after, changes);
    return arguments.common.is_quiet() ? last_line(table) : table;
}

}  // namespace

ExitCode execute(const DiffResultsArguments& arguments) {
    const Results before = read_results(arguments.before), after = read_results(arguments.after);
    const std::vector<ViewChange> changes =
        changes_between(with_defects(before, folder_of_results(arguments.before)),
                        with_defects(after, folder_of_results(arguments.after)));
    require_one_size(changes);
    std::cout << told(arguments, before, after, changes);
    return std::ranges::any_of(changes, is_worse) ? ExitCode::defect : ExitCode::proven;
}

}  // namespace zproof
