#include "reports/output_folder.h"

#include <unistd.h>

#include <fstream>
#include <string>

namespace zproof {

namespace {

namespace fs = std::filesystem;

constexpr const char* marker = ".zproof-out";

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
    if (fs::exists(path / marker, failure)) return;
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

void mark(const fs::path& folder) {
    std::ofstream out(folder / marker);
    out << "zproof made this folder and replaces it whole.\n";
    out.close();
    if (!out) refuse(folder, "cannot be written to");
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& path) : path_(settled(path)) {
    require_replaceable(path_);
    working_ = make_sibling(path_, "tmp");
    try {
        mark(working_);
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

void OutputFolder::publish() {
    require_replaceable(path_);
    const fs::path old = make_sibling(path_, "old");  // empty: rename() may take its place
    std::error_code failure, ignored;
    const bool replaces = fs::exists(path_, ignored);
    if (replaces) fs::rename(path_, old, failure);
    if (!failure) fs::rename(working_, path_, failure);
    if (failure) {
        if (replaces && !fs::exists(path_, ignored)) fs::rename(old, path_, ignored);
        fs::remove(old, ignored);  // only where it is empty
        refuse(path_, "cannot be put in place: " + failure.message());
    }
    published_ = true;
    fs::remove_all(old, ignored);  // the new folder stands; a remnant named PATH.old-PID does no harm
}

}  // namespace zproof
