#include "rasterizer/clip.h"

#include <algorithm>

namespace zproof::rasterizer {
namespace {

enum class ClipPlane { near, far, left, right, bottom, top };

constexpr std::array all_planes{ClipPlane::near,  ClipPlane::far,    ClipPlane::left,
                                ClipPlane::right, ClipPlane::bottom, ClipPlane::top};

/// Positive inside; +inf for a plane at infinity.
double distance(ClipPlane plane, const ClipVertex& v, const ClipVolume& volume) {
    switch (plane) {
        case ClipPlane::near:
            return v.depth - volume.near_depth;
        case ClipPlane::far:
            return volume.far_depth - v.depth;
        case ClipPlane::left:
            return v.x + volume.guard_x * v.w;
        case ClipPlane::right:
            return volume.guard_x * v.w - v.x;
        case ClipPlane::bottom:
            return v.y + volume.guard_y * v.w;
        case ClipPlane::top:
            return volume.guard_y * v.w - v.y;
    }
    return 0;
}

void set_depth(ClipVertex& v, double depth, Projection projection) {
    v.depth = depth;
    if (projection == Projection::perspective) v.w = depth;
}

/// Both weights come from the distances: 1 - weight would cancel where the far end of a long edge is inside.
/// Rounding may not carry depth past the ends of the edge.
ClipVertex weighted_sum(const ClipVertex& a, double weight_a, const ClipVertex& b, double weight_b,
                        Projection projection) {
    ClipVertex v{a.x * weight_a + b.x * weight_b, a.y * weight_a + b.y * weight_b, a.w, a.depth};
    const auto [least, greatest] = std::minmax(a.depth, b.depth);
    set_depth(v, std::clamp(a.depth * weight_a + b.depth * weight_b, least, greatest), projection);
    return v;
}

/// Puts the coordinate that the plane fixes exactly where the plane is, however long the edge was that it
/// came from.
void put_on(ClipPlane plane, ClipVertex& v, const ClipVolume& volume) {
    switch (plane) {
        case ClipPlane::near:
            return set_depth(v, volume.near_depth, volume.projection);
        case ClipPlane::far:
            return set_depth(v, volume.far_depth, volume.projection);
        case ClipPlane::left:
            v.x = -volume.guard_x * v.w;
            return;
        case ClipPlane::right:
            v.x = volume.guard_x * v.w;
            return;
        case ClipPlane::bottom:
            v.y = -volume.guard_y * v.w;
            return;
        case ClipPlane::top:
            v.y = volume.guard_y * v.w;
            return;
    }
}

/// The point where the edge leaves the volume.
ClipVertex intersection(const ClipVertex& inside, const ClipVertex& outside, ClipPlane plane,
                        const ClipVolume& volume) {
    const double d_inside = distance(plane, inside, volume);
    const double d_outside = distance(plane, outside, volume);
    const double length = d_inside - d_outside;
    ClipVertex v = weighted_sum(inside, -d_outside / length, outside, d_inside / length, volume.projection);
    put_on(plane, v, volume);
    return v;
}

bool is_cut_by(ClipPlane plane, const ClipPolygon& polygon, const ClipVolume& volume) {
    return std::ranges::any_of(polygon.span(),
                               [&](const ClipVertex& v) { return distance(plane, v, volume) < 0; });
}

ClipPolygon clip_by(ClipPlane plane, const ClipPolygon& polygon, const ClipVolume& volume) {
    ClipPolygon kept;
    for (int i = 0; i < polygon.size; ++i) {
        const ClipVertex& from = polygon.vertices[std::size_t(i)];
        const ClipVertex& to = polygon.vertices[std::size_t((i + 1) % polygon.size)];
        const bool from_inside = distance(plane, from, volume) >= 0;
        const bool to_inside = distance(plane, to, volume) >= 0;
        if (from_inside) kept.push(from);
        if (from_inside && !to_inside) kept.push(intersection(from, to, plane, volume));
        if (!from_inside && to_inside) kept.push(intersection(to, from, plane, volume));
    }
    return kept;
}

}  // namespace

ClipPolygon clip(const std::array<ClipVertex, 3>& triangle, const ClipVolume& volume) noexcept {
    ClipPolygon polygon;
    for (const ClipVertex& v : triangle) polygon.push(v);
    for (const ClipPlane plane : all_planes) {
        if (is_cut_by(plane, polygon, volume)) polygon = clip_by(plane, polygon, volume);
    }
    return polygon;
}

}  // namespace zproof::rasterizer
