/// A folder that is gone when its owner is.
#pragma once

#include <filesystem>

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

  private:
    std::filesystem::path path_;
};

}  // namespace zproof::oracle
