#include <filesystem>
#include <iostream>

#include "cli/announcement.h"
#include "cli/commands.h"
#include "cli/outcome_code.h"
#include "cli/plan/missing_shards.h"
#include "cli/report_files.h"
#include "frame/printable.h"
#include "program/common_arguments.h"
#include "program/folder_names.h"
#include "program/publish.h"
#include "program/shell_line.h"
#include "reports/merge.h"
#include "reports/output_folder.h"
#include "reports/plan.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// A shard's results. Its views say where their evidence lies now: shards may have used one name for two
/// scenes' folders.
Results read_shard(const fs::path& shard) {
    Results results = read_results(shard);
    for (ViewResult& view : results.views)
        if (!view.folder.empty()) view.folder = (folder_of_results(shard) / view.folder).string();
    return results;
}

Results merged(const std::vector<fs::path>& shards) {
    Merging merging;
    for (const fs::path& shard : shards) merging.add(read_shard(shard), shard.string());
    return std::move(merging).whole();
}

/// Names what is missing. Throws ReportError where anything is, and that is refused.
Results merged(const PlannedShards& planned, const MergeArguments& arguments) {
    Merging merging;
    MissingShards missing(planned);
    for (const fs::path& shard : arguments.shards) {
        const fs::path place = folder_of(planned.run, shard);
        std::string fault;
        Results results;
        try {
            results = read_shard(place);
            fault = missing.fault_of(results);
        } catch (const ReportError& e) {
            fault = e.what();
        }
        if (fault.empty()) {
            missing.found(results.shard.number);
            merging.add(std::move(results), place.string());
        } else {
            std::cerr << "zproof: " << shortened(fault, longest_line_bytes - 10) << "\n";
        }
    }
    for (const std::string& line : missing.commands(arguments.plan, arguments.shards.front()))
        std::cerr << "zproof: " << line << "\n";
    if (missing.count() == 0) return std::move(merging).whole();
    if (arguments.missing == Missing::is_refused || missing.count() == std::size_t(planned.plan.shards))
        throw ReportError{std::to_string(missing.count()) + " of " + std::to_string(planned.plan.shards) +
                          " shards are missing; run them, or merge what is there with --partial"};
    return std::move(merging).partial(missing.views());
}

void copy_evidence(const fs::path& from, const fs::path& to) {
    std::error_code failure;
    fs::create_directories(to.parent_path(), failure);
    fs::copy(from, to, fs::copy_options::recursive, failure);
    if (failure) throw ReportError{from.string() + ": cannot be copied: " + failure.message()};
}

/// The names that one run would have given.
void gather_evidence(const fs::path& folder, Results& whole) {
    FolderNames names;
    for (ViewResult& view : whole.views) {
        if (view.folder.empty()) continue;
        const std::string evidence =
            std::exchange(view.folder, "scenes/" + names.next(view.scene, view.view));
        copy_evidence(evidence, folder / view.folder);
    }
}

/// Scenes have names of their own, and so have the files.
void gather_shrunk(const std::vector<fs::path>& shards, const fs::path& folder) {
    for (const fs::path& shard : shards)
        if (const fs::path shrunk = folder_of_results(shard) / "shrunk"; fs::exists(shrunk))
            copy_evidence(shrunk, folder / "shrunk");
}

/// Writes what one run would have written. `argv` is that run's, but for -o.
ExitCode write_whole(Results whole, const std::vector<fs::path>& shards, const ReportArguments& report) {
    const CommonArguments& common = report.common;
    if (common.out != ReportArguments{}.common.out) {
        whole.argv.emplace_back("-o");
        whole.argv.push_back(common.out.string());
    }
    whole.command = shell_line(whole.argv);
    OutputFolder out{common.out};
    gather_evidence(out.working(), whole);
    gather_shrunk(shards, out.working());
    on_threads(common.threads, [&] { write_reports(out.working(), whole, report.formats); });
    publish(out, common, whole.ending == Ending::complete ? Completeness::full : Completeness::partial);
    return announce(whole, report, SummaryStyle::Rows::each_view);
}

}  // namespace

ExitCode execute(const MergeArguments& arguments) {
    if (arguments.plan.empty())
        return write_whole(merged(arguments.shards), arguments.shards, arguments.report);
    const Plan plan = read_plan(arguments.plan);
    std::vector<ExitCode> codes;
    for (const PlannedRun& run : plan.runs) {
        Results whole = merged({plan, run}, arguments);
        whole.argv = run.argv;
        std::vector<fs::path> shards;
        for (const fs::path& shard : arguments.shards) shards.push_back(folder_of(run, shard));
        codes.push_back(write_whole(std::move(whole), shards, report_of(run, arguments.report)));
    }
    return worst_of(codes);
}

}  // namespace zproof
