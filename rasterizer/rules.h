/// The rules of rasterization, as data of the pipeline.
///
/// The library draws by `correct_rules` and by nothing else: render() of rasterizer.h takes no rules. Other
/// rules exist so that tests can plant a known defect (tests/support/planted_rules.h) through render_by() of
/// pipeline.h and see the judge find it. A rule is read while a view, a vertex or an edge is set up, never
/// per pixel.
#pragma once

#include "frame/precision.h"

namespace zproof::rasterizer {

/// Who owns a sample that lies exactly on an edge.
enum class FillRule {
    top_left,  ///< the triangle whose top or left edge it is: exactly one of two neighbours (D3D11.3 3.4.2.1)
    exclusive,  ///< nobody: holes along shared edges
    inclusive,  ///< everybody: double hits along shared edges
};

/// What is interpolated linearly over a triangle's raster image.
enum class DepthInterpolation {
    perspective_correct,  ///< 1/depth for perspective, depth for parallel projections
    affine,               ///< depth itself, also under perspective
};

enum class DepthTest {
    nearer_wins,   ///< an equal depth keeps the earlier triangle
    farther_wins,  ///< an equal depth keeps the earlier triangle
};

enum class NearClip {
    at_near_plane,
    just_before_the_eye,  ///< whatever lies between eye and near plane is drawn too
};

/// The direction of raster y.
enum class RasterY { down, up };

struct Rules {
    int subpixel_bits = 8;          ///< vertices snap to 2^-subpixel_bits px; 1 to 12 (see guard_band_px)
    Snap snap = Snap::nearest;      ///< onto that grid; truncation is towards 0
    double sample_offset_px = 0.5;  ///< from a pixel's upper left corner to its sample, in x and in y
    FillRule fill = FillRule::top_left;
    DepthInterpolation depth_interpolation = DepthInterpolation::perspective_correct;
    DepthTest depth_test = DepthTest::nearer_wins;
    NearClip near_clip = NearClip::at_near_plane;
    RasterY raster_y = RasterY::down;
};

inline constexpr Rules correct_rules{};

}  // namespace zproof::rasterizer
