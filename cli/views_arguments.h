/// The arguments of zproof views.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>

#include "program/common_arguments.h"
#include "scenes/import/calibrated_camera.h"

namespace zproof {

/// Whose file of cameras it is.
enum class CameraSource { opencv, colmap, nerf };

struct ViewsArguments {
    CommonArguments common{
        .output = Output::file};  ///< the view file; no default, so that none is replaced unasked
    CameraSource source = CameraSource::opencv;
    std::filesystem::path cameras;  ///< COLMAP: a folder
    std::filesystem::path model;
    DepthRange range{.near_depth = 0, .far_depth = std::numeric_limits<double>::infinity()};
    std::optional<glm::ivec2> image_size;  ///< of files that do not say it
};

}  // namespace zproof
