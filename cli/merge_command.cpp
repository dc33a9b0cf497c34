#include <filesystem>
#include <map>

#include "cli/announcement.h"
#include "cli/commands.h"
#include "cli/folder_names.h"
#include "cli/published.h"
#include "cli/report_files.h"
#include "cli/threads.h"
#include "cli/usage_error.h"
#include "reports/merge.h"
#include "reports/output_folder.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// Where each view's evidence lies now: shards may have used one name for two scenes' folders.
std::vector<fs::path> evidence_of(const std::vector<Results>& shards, const std::vector<fs::path>& folders) {
    std::multimap<std::uint64_t, fs::path> by_place;
    for (std::size_t i = 0; i < shards.size(); ++i)
        for (const ViewResult& view : shards[i].views)
            by_place.emplace(view.place, view.folder.empty() ? fs::path{} : folders[i] / view.folder);
    std::vector<fs::path> evidence;
    for (auto& [place, folder] : by_place) evidence.push_back(folder);
    return evidence;
}

void copy_evidence(const fs::path& from, const fs::path& to) {
    std::error_code failure;
    fs::create_directories(to.parent_path(), failure);
    fs::copy(from, to, fs::copy_options::recursive, failure);
    if (failure) throw ReportError{from.string() + ": cannot be copied: " + failure.message()};
}

/// The names that one run would have given.
void gather_evidence(const std::vector<fs::path>& evidence, const fs::path& folder, Results& whole) {
    FolderNames names;
    for (std::size_t i = 0; i < whole.views.size(); ++i) {
        ViewResult& view = whole.views[i];
        if (view.folder.empty()) continue;
        view.folder = "scenes/" + names.next(view.scene, view.view);
        copy_evidence(evidence[i], folder / view.folder);
    }
}

/// Scenes have names of their own, and so have the files.
void gather_shrunk(const std::vector<fs::path>& folders, const fs::path& folder) {
    for (const fs::path& shard : folders)
        if (fs::exists(shard / "shrunk")) copy_evidence(shard / "shrunk", folder / "shrunk");
}

}  // namespace

ExitCode execute(const MergeArguments& arguments) {
    std::vector<Results> shards;
    std::vector<std::string> names;
    std::vector<fs::path> folders;
    for (const fs::path& shard : arguments.shards) {
        shards.push_back(read_results(shard));
        names.push_back(shard.string());
        folders.push_back(folder_of_results(shard));
    }
    Results whole = merged(shards, names);
    const CommonArguments& common = arguments.report.common;
    if (common.out != ReportArguments{}.common.out) {
        whole.argv.emplace_back("-o");
        whole.argv.push_back(common.out.string());
    }
    whole.command = shell_line(whole.argv);
    OutputFolder out{common.out};
    gather_evidence(evidence_of(shards, folders), out.working(), whole);
    gather_shrunk(folders, out.working());
    on_threads(common.threads, [&] { write_reports(out.working(), whole, arguments.report.formats); });
    publish(out, common);
    return announce(whole, arguments.report);
}

}  // namespace zproof
