/// Views from other programs' files of cameras (docs/conventions.md).
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "scenes/import/calibrated_camera.h"

namespace zproof {

// Each throws SceneError, naming file and place, for what is missing, unknown or out of range, for cameras
// that are no pinhole (COLMAP's where no other is left), and for two views of one name.

/// OpenCV's K, R and t, as JSON: {"views": [{"name", "width", "height", "pixel_centre", "K", "R", "t"}]}.
std::vector<ImportedView> import_opencv(const std::filesystem::path& file, const DepthRange& range);

struct ImportedViews {
    std::vector<ImportedView> views;
    std::vector<std::string> left_out = {};  ///< for each camera that is no pinhole: why, and its images
};

/// cameras.txt and images.txt of a COLMAP model, in this folder.
ImportedViews import_colmap(const std::filesystem::path& folder, const DepthRange& range);

/// transforms.json of NeRF, instant-ngp or nerfstudio. `size` is the images', for files that do not say it.
std::vector<ImportedView> import_nerf(const std::filesystem::path& file, const DepthRange& range,
                                      const std::optional<glm::ivec2>& size);

/// Throws SceneError where there is no view, or two of one name.
void require_unique_names(const std::filesystem::path& file, const std::vector<ImportedView>& views);

}  // namespace zproof
