/// Files from a scene's own folder, and from nowhere else.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "math/bulk.h"

namespace zproof {

using Bytes = Bulk<unsigned char>;

/// Reads a regular file of at most limit bytes. Throws SceneError for anything else.
Bytes read_file(const std::filesystem::path& file, std::uint64_t limit);

/// UTF-8's mark, no part of the text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The bytes as UTF-8, without a byte order mark. Throws SceneError for UTF-16.
std::string_view text_in(const std::filesystem::path& file, std::span<const unsigned char> bytes);

/// Fills the span with the file's first bytes, on all threads: most of the time goes by in fetching memory
/// for them. Throws SceneError where there are fewer.
void read_first(const std::filesystem::path& file, std::span<unsigned char> to);

/// The file that a relative path names beneath the folder of `from`: no scheme, not absolute, no step
/// outside, neither by ".." nor by a symbolic link, and a regular file. Throws SceneError, naming from and
/// place, with the remedy at its end.
std::filesystem::path beneath_folder_of(
    const std::filesystem::path& from, const std::string& place, const std::string& relative,
    const std::string& remedy = "put the file next to the scene and name it by a relative path");

/// The file that a relative path names from the folder of `from` or else from `root`, and that lies beneath
/// either, symbolic links resolved: a view file's model where a folder of models is named. Throws SceneError,
/// naming from and place.
std::filesystem::path beneath_folder_or_root(const std::filesystem::path& from, const std::string& place,
                                             const std::string& relative, const std::filesystem::path& root);

/// A URI without its %XX escapes.
std::string percent_decoded(const std::string& uri);

/// An external file that a scene may open, and how many of its bytes it takes.
struct AdmittedFile {
    std::filesystem::path path;
    std::uint64_t bytes = 0;
};

/// Says which external files one scene may open.
class Admission {
  public:
    explicit Admission(std::filesystem::path scene_file) : scene_file_(std::move(scene_file)) {}

    /// The file that the URI names, of which the scene takes the first `declared` bytes, or all. Throws
    /// SceneError where it is missing, shorter, outside the scene's folder or beyond limits.
    AdmittedFile admit(const std::string& place, const std::string& uri,
                       std::optional<std::uint64_t> declared = {});

  private:
    std::filesystem::path scene_file_;
    std::uint64_t total_bytes_ = 0;
};

}  // namespace zproof
