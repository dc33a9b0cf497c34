/// One process at a time in a folder.
#pragma once

#include <filesystem>

namespace zproof {

/// While it lives, no other process holds a lock of this kind on the folder (flock). The kernel lifts it when
/// the process ends, however it ends, and nothing is left behind.
class FolderLock {
  public:
    /// Waits for whoever holds it. Throws FrameError where the folder cannot be locked.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

/// The folder in which a file lies, links followed; "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace zproof
