/// A folder that is gone when its owner is.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

namespace zproof::oracle {

/// A new, empty folder below the system's folder for temporary files (TMPDIR, else /tmp), readable for its
/// owner alone. Destruction removes it with all that it holds.
class ScratchFolder {
  public:
    /// Throws OracleError, naming the place, where it cannot be made.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// A file in it with these bytes. Throws OracleError where there is no room for them.
    void write(const std::string& name, const std::string& bytes) const;

  private:
    std::filesystem::path path_;
};

/// Removes those that a process which has crashed left behind.
void remove_scratch_folders_of(pid_t process);

}  // namespace zproof::oracle
