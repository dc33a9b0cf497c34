/// Files from a scene's own folder, and from nowhere else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "math/bulk.h"

namespace zproof {

using Bytes = Bulk<unsigned char>;

/// Reads a regular file of at most limit bytes. Throws SceneError for anything else.
Bytes read_file(const std::filesystem::path& file, std::uint64_t limit);

/// The file that a relative path names beneath the folder of `from`: no scheme, not absolute, no step
/// outside, neither by ".." nor by a symbolic link, and a regular file. Throws SceneError, naming from and
/// place.
std::filesystem::path beneath_folder_of(const std::filesystem::path& from, const std::string& place,
                                        const std::string& relative);

/// A URI without its %XX escapes.
std::string percent_decoded(const std::string& uri);

/// The external files that one scene may open, admitted before anything is read.
class Admitted {
  public:
    explicit Admitted(std::filesystem::path scene_file) : scene_file_(std::move(scene_file)) {}

    /// Admits the first `bytes` bytes of a buffer's file. Throws SceneError where it is missing or shorter.
    void admit_buffer(const std::string& place, const std::string& uri, std::uint64_t bytes);
    /// Admits an image's whole file. Throws SceneError where it is missing.
    void admit_image(const std::string& place, const std::string& uri);

    /// The bytes of an admitted file.
    Bytes read(const std::string& uri) const;

  private:
    struct Entry {
        std::filesystem::path file;
        std::uint64_t bytes = 0;
    };
    void admit(const std::string& place, const std::string& uri, Entry entry);

    std::filesystem::path scene_file_;
    std::map<std::string, Entry> files_;
    std::uint64_t total_bytes_ = 0;
};

}  // namespace zproof
