/// Exact edge functions on the sub-pixel grid, and the fill rule.
#pragma once

#include <cstdint>

#include "rasterizer/rules.h"
#include "rasterizer/snap.h"

namespace zproof::rasterizer {

/// E(p) = a p.x + b p.y + c, positive on the inner side of an edge of a clockwise (y down) triangle.
/// With 24.8 points inside the guard band E is 48.16, exact, and |E| <= 2^51 (see guard_band_px).
struct EdgeFunction {
    std::int64_t a = 0, b = 0, c = 0;
    std::int64_t least = 0;  ///< the least E that is covered: 0 where the edge owns the samples on it, else 1

    constexpr std::int64_t at(SnappedPoint p) const { return a * p.x + b * p.y + c; }
    constexpr bool covers(SnappedPoint p) const { return at(p) >= least; }
};

/// Top-left rule: a left edge runs up, a top edge is level and runs right.
constexpr bool is_top_left(std::int64_t dx, std::int64_t dy) { return dy < 0 || (dy == 0 && dx > 0); }

enum class EdgeKind { top_left, other };

/// The least E that an edge's triangle covers: 0 where the edge owns the samples on it, else 1.
constexpr std::int32_t least_covered(FillRule rule, EdgeKind kind) {
    const bool owns_its_samples =
        rule == FillRule::inclusive || (rule == FillRule::top_left && kind == EdgeKind::top_left);
    return owns_its_samples ? 0 : 1;
}

constexpr EdgeFunction edge_between(SnappedPoint from, SnappedPoint to, FillRule rule = FillRule::top_left) {
    const std::int64_t dx = std::int64_t{to.x} - from.x;
    const std::int64_t dy = std::int64_t{to.y} - from.y;
    const EdgeKind kind = is_top_left(dx, dy) ? EdgeKind::top_left : EdgeKind::other;
    return {.a = -dy, .b = dx, .c = dy * from.x - dx * from.y, .least = least_covered(rule, kind)};
}

}  // namespace zproof::rasterizer
