/// What a renderer promises about its arithmetic. The judge knows a renderer by this alone (docs/bounds.md).
#pragma once

#include <variant>

namespace zproof {

enum class Arithmetic {
    float32,  ///< IEEE binary32, round to nearest
    float64,  ///< IEEE binary64, round to nearest
};

/// What corners are relative to when they meet the matrix.
enum class Origin {
    world,  ///< one fused clip_from_world matrix
    eye,    ///< the eye is subtracted first, rounded once
};

/// How a vertex reaches its place on the sub-pixel grid.
enum class Snap {
    nearest,   ///< moves by at most half a grid step in x and in y
    truncate,  ///< moves by less than a whole step
};

/// What clipping in float32 leaves of a triangle that reaches beyond the image.
enum class Clipping {
    guard_band,   ///< only what the near plane or +-32768 px cut gets new corners
    view_volume,  ///< every side of the image, near and far make new corners
};

/// What the depth buffer holds.
enum class DepthBuffer {
    /// Depth itself, interpolated from the snapped triangle's barycentrics (1/depth for perspective, depth
    /// for
    /// parallel projections): never beyond the corners' depths.
    camera_depth,
    /// z in [0, 1] with 1 at near, as float32: near / depth for perspective, (far - depth) / (far - near) for
    /// parallel projections. Interpolated by a plane equation in float32 through the corners, snapped or not,
    /// with
    /// the window's corner as its origin; turned back into depth without loss, then rounded.
    reversed_z,
};

/// A z-buffer rasterizer: a matrix, division by w, viewport, snap, and an interpolated depth.
struct RasterPrecision {
    Arithmetic transform = Arithmetic::float32;  ///< of matrix, division and viewport
    Origin origin = Origin::world;               ///< what the matrix is applied to
    int subpixel_bits = 8;                       ///< grid step is 2^-subpixel_bits px
    Snap snap = Snap::nearest;                   ///< onto that grid
    Clipping clipping = Clipping::guard_band;
    DepthBuffer depth_buffer = DepthBuffer::camera_depth;
    Arithmetic interpolation = Arithmetic::float32;  ///< of camera_depth's functional
    int depth_roundings = 2;                         ///< float32 roundings from interpolant to reported depth
};

/// A ray caster: one ray per pixel centre against the world-space triangle, edges tested by the signs of
/// Pluecker products. Origins, directions and vertices are rounded to this arithmetic.
struct RayPrecision {
    Arithmetic arithmetic = Arithmetic::float32;
};

/// A ray caster in float64: it meets a triangle's plane, whose unit normal and offset were computed once, and
/// then asks whether the point lies inside, in the two axes that are farthest from the normal. Corners are
/// rounded once when the eye is subtracted.
struct PlaneRayPrecision {
    double aim_offset_px = 0;  ///< rays may pass this far beside the pixel's centre, in x and in y
    double least_corner_sine =
        0x1p-26;  ///< triangles with a smaller sine at their second corner are not drawn
    double least_grazing_sine = 1e-10;  ///< a ray does not meet a plane at a smaller sine
    double depth_relative = 0x1p-24;    ///< error of the reported depth beside that of the hit itself
    double depth_of_range = 0;          ///< parallel: a further one, as a share of far - near
    double clip_relative = 0;           ///< error of near and far, as a share of themselves
    double clip_of_reach = 0;           ///< parallel: a further one, as a share of the coordinates' size
};

using Precision = std::variant<RasterPrecision, RayPrecision, PlaneRayPrecision>;

}  // namespace zproof
