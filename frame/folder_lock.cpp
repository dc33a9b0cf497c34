#include "frame/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "frame/frame_error.h"

namespace zproof {

FolderLock::FolderLock(const std::filesystem::path& folder) : FolderLock(folder, OnBusy::waits) {}

FolderLock::FolderLock(const std::filesystem::path& folder, OnBusy on_busy)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    const int how = on_busy == OnBusy::waits ? LOCK_EX : LOCK_EX | LOCK_NB;
    int answer = descriptor_;
    while (descriptor_ >= 0 && (answer = flock(descriptor_, how)) != 0 && errno == EINTR) continue;
    if (answer >= 0) return;
    const std::string why = std::strerror(errno);
    if (descriptor_ >= 0) close(descriptor_);
    throw FrameError(folder.string() + ": cannot be locked: " + why +
                     "; expected an existing folder on a file system that has locks (flock)");
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

std::optional<FolderLock> FolderLock::if_free(const std::filesystem::path& folder) try {
    return FolderLock(folder, OnBusy::does_not_wait);
} catch (const FrameError&) {
    return std::nullopt;
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
    std::error_code unknown;
    const std::filesystem::path place = std::filesystem::weakly_canonical(file, unknown);
    const std::filesystem::path folder = (unknown ? file : place).parent_path();
    return folder.empty() ? "." : folder;
}

}  // namespace zproof
