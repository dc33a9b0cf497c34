/// What the numbers in somebody's picture file stand for: facts that its owner declares
/// (docs/conventions.md).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace zproof {

/// How an id is stored.
enum class IdCoding {
    integer,
    real,  ///< "float": a whole number in a floating-point sample
    rgb,   ///< three channels of 8 bits, R the lowest byte
    bgr,   ///< three channels of 8 bits, B the lowest byte
};

/// Which of a pixel's two numbers says that it shows nothing.
enum class BackgroundBy { id, depth };

enum class RowOrder { top_first, bottom_first };

/// What a stored depth measures, after its scale was applied.
enum class DepthKind {
    camera,                ///< along the view axis
    ray_length,            ///< from the eye (parallel: from the plane through the eye)
    ray_length_from_near,  ///< along the ray from the near plane
    ndc_z,                 ///< -1 at near, 1 at far
    window_z,              ///< 0 at near, 1 at far
    reversed_z,            ///< 1 at near, 0 at far
    inverse,               ///< 1 / camera depth
    disparity,             ///< pixels: focal length in pixels x baseline / camera depth
};

/// The default is what the renderer contract asks for.
struct Convention {
    std::string id_channel = "id", depth_channel = "Z";
    IdCoding id_coding = IdCoding::integer;
    std::uint32_t id_base = 0;                  ///< the number of the scene's first triangle
    std::optional<std::int64_t> id_background;  ///< nothing: the largest value of the type
    BackgroundBy background_by = BackgroundBy::id;
    RowOrder rows = RowOrder::top_first;
    DepthKind depth_kind = DepthKind::camera;
    double depth_scale = 1;          ///< what a stored 1 stands for
    bool depth_is_whole = false;     ///< rounded to the nearest integer; of camera depth alone
    std::optional<double> baseline;  ///< scene units; of a disparity, and of nothing else
    /// Stored values that are no depth but say "background".
    std::vector<double> background_depths{std::numeric_limits<double>::infinity()};
    bool far_is_background = false;  ///< so does what a surface on the far plane would have

    /// Between two depths that it can hold, scene units; 0 where they are floats.
    double depth_step() const { return depth_is_whole ? depth_scale : 0; }

    bool operator==(const Convention&) const = default;
};

}  // namespace zproof
