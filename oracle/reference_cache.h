/// Reference frames in a folder, for other runs: a second renderer's views are not traced again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "frame/frame.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// Where frames are kept, and how much room they may take.
struct ReferenceCacheChoice {
    std::filesystem::path folder{};  ///< empty: they are not kept
    std::uint64_t most_bytes = std::uint64_t{10} << 30;
};

/// Everything that the reference's frame of a view depends on, as text: the scene's SHA-256, the camera, the
/// picture's size, where pixels are sampled, and who traces it (embree_version(), zproof's commit).
std::string reference_key(const std::string& scene_sha256, const View& view, const std::string& tracer);

/// Many processes on one file system may use one folder. A file appears whole or not at all, says what it is
/// of, and holds the SHA-256 of all that it says.
class ReferenceCache {
  public:
    /// Makes the folder. Throws OracleError where that fails.
    explicit ReferenceCache(ReferenceCacheChoice choice);

    /// The frame that was kept under this key. Nothing where there is none, or where the file is not as it
    /// was written: that file is removed.
    std::optional<Frame> find(const std::string& key, Resolution size) const;

    /// Keeps ids and depths. Where the folder grows beyond its limit, the files go that were not asked for
    /// the longest. A frame that cannot be written is not kept, and nobody is told: the next run traces it.
    void keep(const std::string& key, const Frame& frame);

  private:
    std::filesystem::path file_of(const std::string& key) const;
    void make_room();

    ReferenceCacheChoice choice_;
    std::mutex keeping_;
    std::uint64_t uncounted_bytes_;  ///< written since the folder's files were added up
};

}  // namespace zproof::oracle
