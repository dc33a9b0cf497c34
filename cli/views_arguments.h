/// The arguments of zproof views.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>

#include "scenes/import/calibrated_camera.h"

namespace zproof {

/// Whose file of cameras it is.
enum class CameraSource { opencv, colmap, nerf };

struct ViewsArguments {
    CameraSource source = CameraSource::opencv;
    std::filesystem::path cameras;  ///< COLMAP: a folder
    std::filesystem::path model;
    std::filesystem::path out;  ///< the view file; not a default, so that none is replaced unasked
    DepthRange range{.near_depth = 0, .far_depth = std::numeric_limits<double>::infinity()};
    std::optional<glm::ivec2> image_size;  ///< of files that do not say it
};

}  // namespace zproof
