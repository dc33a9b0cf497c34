#include "reports/output_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "reports/output_manifest.h"
#include "reports/replaced_folder.h"

namespace zproof {

namespace {

namespace fs = std::filesystem;

constexpr const char* partial_suffix = ".partial";

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
    throw ReportError(path.string() + ": " + why);
}

/// Absolute, without links and without a trailing slash, so that siblings can be named.
fs::path settled(const fs::path& path) {
    std::error_code failure;
    fs::path whole = fs::weakly_canonical(fs::absolute(path, failure), failure);
    if (failure || path.empty()) refuse(path, "is no usable path for an output folder");
    return whole.has_filename() ? whole : whole.parent_path();
}

/// Throws unless replacing path can destroy nothing but zproof's own output.
void require_replaceable(const fs::path& path) {
    std::error_code failure;
    if (!fs::exists(fs::symlink_status(path, failure))) return;
    if (!fs::is_directory(path, failure))
        refuse(path, "exists and is not a folder; choose another output folder");
    if (manifest_in(path)) return;
    if (fs::exists(path / output_marker, failure))
        refuse(path,
               "was made by a zproof that kept no list of its files; remove it, or choose another output "
               "folder");
    const bool empty = fs::is_empty(path, failure);
    if (failure) refuse(path, "cannot be read: " + failure.message());
    if (!empty)
        refuse(path,
               "exists and was not made by zproof (it holds no .zproof-out); choose another output folder");
}

fs::path sibling(const fs::path& path, const std::string& role, int attempt) {
    const std::string again = attempt == 0 ? "" : "-" + std::to_string(attempt);
    return path.string() + "." + role + "-" + std::to_string(::getpid()) + again;
}

/// A sibling of path that did not exist, made. A folder left by a crashed process of the same number stays as
/// it is.
fs::path make_sibling(const fs::path& path, const std::string& role) {
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    for (int attempt = 0; !failure; ++attempt) {
        const fs::path made = sibling(path, role, attempt);
        if (fs::create_directory(made, failure)) return made;
        if (failure == std::errc::file_exists) failure.clear();
    }
    refuse(path, "cannot be made: " + failure.message());
}

/// One step: at no time there is no folder at either place. False where the file system cannot do it.
bool exchange(const fs::path& a, const fs::path& b) {
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

/// Gives `folder` the place of `path`. Returns where the old one lies then.
fs::path put_in_place(const fs::path& folder, const fs::path& path) {
    if (exchange(folder, path)) return folder;
    const fs::path old = make_sibling(path, "old");  // empty: rename() may take its place
    std::error_code failure, ignored;
    const bool replaces = fs::exists(path, ignored);
    if (replaces) fs::rename(path, old, failure);
    if (!failure) fs::rename(folder, path, failure);
    if (!failure) return old;
    if (replaces && !fs::exists(path, ignored)) fs::rename(old, path, ignored);
    fs::remove(old, ignored);  // only where it is empty
    refuse(path, "cannot be put in place: " + failure.message());
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& path) : path_(settled(path)) {
    kept_ = tidy_up_beside(path_);
    require_replaceable(path_);
    working_ = make_sibling(path_, "tmp");
    lock_ = FolderLock::if_free(working_);
    try {
        mark_unfinished(working_);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(working_, ignored);
        throw;
    }
}

OutputFolder::~OutputFolder() {
    std::error_code ignored;
    if (!published_) fs::remove_all(working_, ignored);
}

std::vector<fs::path> OutputFolder::publish(Completeness completeness) {
    if (completeness == Completeness::partial && is_full(path_)) suffix_ = partial_suffix;
    const fs::path place = path_.string() + suffix_;
    require_replaceable(place);
    mark_finished(working_, completeness);
    const fs::path old = put_in_place(working_, place);
    published_ = true;
    std::ranges::move(retire(old, place), std::back_inserter(kept_));
    if (const fs::path partial = path_.string() + partial_suffix;
        completeness == Completeness::full && manifest_in(partial) && !is_full(partial))
        std::ranges::move(retire(partial, place), std::back_inserter(kept_));
    return kept_;
}

}  // namespace zproof
