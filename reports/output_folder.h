/// The folder that a run leaves behind.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frame/folder_lock.h"
#include "reports/output_manifest.h"
#include "reports/report_error.h"

namespace zproof {

/// An output folder that appears whole or not at all: written as PATH.tmp-PID, put in place by publish().
/// Replaces PATH only where PATH is a folder that zproof itself made (it holds .zproof-out) or an empty one;
/// otherwise the constructor throws ReportError and touches nothing. The destructor removes what was not
/// published.
///
/// It replaces only those files in a folder that .zproof-out lists, and only where they are as
/// they were written. Everything else is moved into the new folder, under its own name or, where that is
/// taken, NAME.kept.
class OutputFolder {
  public:
    /// Also tidies up after runs into the same PATH that were killed: what they had not finished is removed,
    /// and a PATH that they had renamed away is put back.
    explicit OutputFolder(const std::filesystem::path& path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const std::filesystem::path& working() const { return working_; }  ///< where to write

    /// Puts the working folder in PATH's place, or in that of PATH.partial where it is a partial one and PATH
    /// a full one, in one step where the file system can exchange two folders
    /// (renameat2); otherwise the old one is renamed away first. Whenever the process dies, a whole folder is
    /// left, old or new. Throws ReportError where a rename fails or PATH has become somebody else's
    /// meanwhile; PATH is then as it was. To be called once. A full folder also ends what an interrupted run
    /// had left at PATH.partial. Returns what was kept of the old folders though zproof did not write it:
    /// where it lies now.
    [[nodiscard]] std::vector<std::filesystem::path> publish(Completeness completeness = Completeness::full);

    /// What publish() added to PATH: ".partial" or nothing.
    const std::string& suffix() const { return suffix_; }

  private:
    std::filesystem::path path_, working_;
    std::optional<FolderLock> lock_;                ///< of working_: its process lives
    std::vector<std::filesystem::path> kept_ = {};  ///< from the folders of runs that were killed
    std::string suffix_ = {};
    bool published_ = false;
};

}  // namespace zproof
