#include "reports/replaced_folder.h"

#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>

#include "frame/folder_lock.h"
#include "reports/output_manifest.h"

namespace zproof {
namespace {

namespace fs = std::filesystem;

/// The paths of all entries below a folder, those of folders behind what lies in them.
struct Entries {
    std::vector<fs::path> files, folders;
};

Entries entries_below(const fs::path& folder) {
    Entries entries;
    std::error_code failure;
    for (auto i = fs::recursive_directory_iterator(folder, failure); !failure && i != end(i);
         i.increment(failure)) {
        const bool is_folder = i->symlink_status(failure).type() == fs::file_type::directory;
        (is_folder ? entries.folders : entries.files).push_back(i->path().lexically_relative(folder));
    }
    std::ranges::sort(entries.files);
    std::ranges::sort(entries.folders, std::greater{});
    return entries;
}

bool is_there(const fs::path& path) {
    std::error_code failure;
    return fs::exists(fs::symlink_status(path, failure));
}

/// NAME, NAME.kept, NAME.kept-2, ...: the first that is free.
fs::path free_name(const fs::path& wanted) {
    fs::path name = wanted;
    for (int i = 1; is_there(name); ++i)
        name = wanted.string() + ".kept" + (i == 1 ? "" : "-" + std::to_string(i));
    return name;
}

/// Where the file lies then: where it was, if it cannot be moved.
fs::path moved(const fs::path& file, const fs::path& wanted) {
    std::error_code failure;
    fs::create_directories(wanted.parent_path(), failure);
    const fs::path place = free_name(wanted);
    fs::rename(file, place, failure);
    return failure ? file : place;
}

/// PATH.tmp-PID, PATH.old-PID, or one of these with -2, -3, ... behind it.
bool is_of_a_run_into(const fs::path& path, const fs::path& beside) {
    const std::string name = beside.filename().string(), stem = path.filename().string();
    if (!name.starts_with(stem + ".tmp-") && !name.starts_with(stem + ".old-")) return false;
    return name.find_first_not_of("0123456789-", stem.size() + 5) == std::string::npos;
}

/// The process that made it, or another of its number, runs: its folder may be so new that it is still empty.
bool is_of_a_living_process(const fs::path& path, const fs::path& beside) {
    const std::string number = beside.filename().string().substr(path.filename().string().size() + 5);
    return ::kill(std::atoi(number.c_str()), 0) == 0 || errno != ESRCH;
}

/// The list of what could not be removed stays: the next run tries again.
void remove_with_list(const fs::path& old) {
    const Entries left = entries_below(old);
    const auto is_list = [](const fs::path& name) { return name == output_marker; };
    if (!left.folders.empty() || !std::ranges::all_of(left.files, is_list)) return;
    std::error_code ignored;
    fs::remove(old / output_marker, ignored);
    fs::remove(old, ignored);
}

}  // namespace

std::vector<fs::path> retire(const fs::path& old, const fs::path& path) {
    const OutputManifest written = manifest_in(old).value_or(OutputManifest{});
    Entries entries = entries_below(old);
    std::stable_partition(entries.files.begin(), entries.files.end(), [&](const fs::path& name) {
        return !written.contains(name.generic_string());  // these first: they keep their names
    });
    std::vector<fs::path> kept;
    std::error_code ignored;
    for (const fs::path& name : entries.files) {
        if (name == output_marker) continue;
        const auto listed = written.find(name.generic_string());
        if (listed != written.end() && as_it_is(old / name) == listed->second)
            fs::remove(old / name, ignored);
        else if (is_there(old / name))
            kept.push_back(moved(old / name, path / name));
    }
    for (const fs::path& name : entries.folders) fs::remove(old / name, ignored);  // only where it is empty
    const auto stays = [&](const fs::path& file) { return file.native().starts_with(old.native() + "/"); };
    if (std::ranges::any_of(kept, stays)) return kept;
    remove_with_list(old);
    return kept;
}

std::vector<fs::path> tidy_up_beside(const fs::path& path) {
    std::vector<fs::path> left, kept;
    std::error_code failure;
    for (auto i = fs::directory_iterator(path.parent_path(), failure); !failure && i != end(i);
         i.increment(failure))
        if (is_of_a_run_into(path, i->path())) left.push_back(i->path());
    std::ranges::sort(left);  // .old- before .tmp-: what was published goes before what was about to be
    for (const fs::path& folder : left) {
        const auto lock = FolderLock::if_free(folder);
        if (!lock) continue;
        if (is_unfinished(folder)) {
            fs::remove_all(folder, failure);
        } else if (manifest_in(folder)) {
            if (!is_there(path))
                fs::rename(folder, path, failure);
            else
                std::ranges::move(retire(folder, path), std::back_inserter(kept));
        } else if (!is_of_a_living_process(path, folder)) {
            fs::remove(folder, failure);  // only where it is empty
        }
    }
    return kept;
}

}  // namespace zproof
