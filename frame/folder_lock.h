/// One process at a time in a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace zproof {

/// While it lives, no other process holds a lock of this kind on the folder (flock). The kernel lifts it when
/// the process ends, however it ends, and nothing is left behind.
class FolderLock {
  public:
    /// Waits for whoever holds it. Throws FrameError where the folder cannot be locked.
    explicit FolderLock(const std::filesystem::path& folder);
    /// Nothing where somebody holds it, or where the folder cannot be locked.
    static std::optional<FolderLock> if_free(const std::filesystem::path& folder);
    FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FolderLock& operator=(FolderLock&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~FolderLock();

  private:
    enum class OnBusy { waits, does_not_wait };
    FolderLock(const std::filesystem::path& folder, OnBusy on_busy);

    int descriptor_;
};

/// The folder in which a file lies, links followed; "." for a bare name.
std::filesystem::path folder_of(const std::filesystem::path& file);

}  // namespace zproof
