/// Clipping in clip space, before any division: near, far and guard band (Sutherland and Hodgman 1974).
///
/// Admissible pictures need every vertex to be divided by w > 0, and the fixed-point edge functions need
/// raster coordinates of limited size. Nothing is clipped against the image's own border: the scan does that
/// exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rasterizer/projection.h"

namespace zproof::rasterizer {

/// Raster coordinates of drawn vertices lie within +-guard_band_px, which holds the largest image (32768 px).
/// On the 24.8 grid that is 2^24 steps; differences are <= 2^25, products of two <= 2^50, and every edge
/// function value and doubled area, a sum of two such products, <= 2^51. So they fit int64, and a double
/// exactly (< 2^53). A finer grid keeps those ranges in a narrower band, 2^24 steps wide on either side: with
/// 12 bits 4096 px, and no larger image.
constexpr double guard_band_px(int subpixel_bits) {
    return subpixel_bits <= 8 ? 65536 : double(1 << (24 - subpixel_bits));
}

/// What may be drawn: near <= depth <= far, |x| <= guard_x w, |y| <= guard_y w. near and far are camera
/// depths, exact facts of the camera, not z_ndc.
struct ClipVolume {
    double near_depth = 0, far_depth = 0;
    double guard_x = 0, guard_y = 0;  ///< the guard band's half-width in NDC
    Projection projection = Projection::perspective;
};

/// The place of a vertex as bits. A triangle is invisible if all its vertices are outside one plane.
namespace outcode {
inline constexpr std::uint8_t left = 1, right = 2, bottom = 4, top = 8, near = 16, far = 32;
inline constexpr std::uint8_t guard = 64;        ///< outside the guard band
inline constexpr std::uint8_t not_finite = 128;  ///< NaN, infinite, or too large to be multiplied further
inline constexpr std::uint8_t invisible = left | right | bottom | top | near | far;
inline constexpr std::uint8_t needs_clip = near | far | guard;
}  // namespace outcode

/// Has no branches, for vectors. What is not usable leaves no room for one product with guard_x < 2^18 and a
/// few sums; float32 positions come nowhere near.
[[gnu::always_inline]] inline std::int32_t outcode_of(const ClipVertex& v,
                                                      const ClipVolume& volume) noexcept {
    constexpr double limit = 0x1p960;
    const double guard_x = volume.guard_x * v.w, guard_y = volume.guard_y * v.w;
    const std::int32_t is_usable = (-limit < v.x) & (v.x < limit) & (-limit < v.y) & (v.y < limit) &
                                   (-limit < v.w) & (v.w < limit) & (-limit < v.depth) & (v.depth < limit);
    const std::int32_t in_guard_band =
        (-guard_x <= v.x) & (v.x <= guard_x) & (-guard_y <= v.y) & (v.y <= guard_y);
    const std::int32_t code =
        (v.x < -v.w) * outcode::left | (v.x > v.w) * outcode::right | (v.y < -v.w) * outcode::bottom |
        (v.y > v.w) * outcode::top | (v.depth < volume.near_depth) * outcode::near |
        (v.depth > volume.far_depth) * outcode::far | (1 - in_guard_band) * outcode::guard;
    return is_usable ? code : outcode::not_finite;
}

/// A convex polygon, up to rounding. A plane adds one vertex to a convex polygon, and half as many as there
/// are to any other: 3 -> 4 -> 6 -> 9 -> 13 -> 19 -> 28 is never exceeded, whatever rounding does to a
/// sliver.
struct ClipPolygon {
    std::array<ClipVertex, 28> vertices;
    int size = 0;

    void push(const ClipVertex& v) { vertices[std::size_t(size++)] = v; }
    std::span<const ClipVertex> span() const { return {vertices.data(), std::size_t(size)}; }
};

/// The part of a triangle inside the volume, in the triangle's winding; empty where there is none.
///
/// An edge is always cut from its inside to its outside vertex, and by all planes in one order whichever
/// triangle it belongs to. So two triangles that share an edge get the same bits, and no crack opens. No
/// vertex may be not_finite.
ClipPolygon clip(const std::array<ClipVertex, 3>& triangle, const ClipVolume& volume) noexcept;

}  // namespace zproof::rasterizer
