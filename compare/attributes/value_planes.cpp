#include "compare/attributes/value_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "compare/bounds/raster_bounds.h"
#include "compare/bounds/window_triangle.h"

namespace zproof {

namespace {

using PieceCorners = std::array<WindowCorner, 3>;

/// May rounding let a side of the window cut a corner off, or leave it?
bool has_corner_at_a_side(const ViewFacts& facts, const TriangleExtent& extent, double drift_px) {
    for (std::size_t i = 0; i < 3; ++i) {
        if (extent.size.depth[i] < facts.view.camera.near_depth) continue;  // near cuts it off
        const glm::dvec2 p = corner_px(facts, extent, i);
        const auto is_at = [&](double at, double side) { return std::abs(at - side) <= drift_px; };
        if (is_at(p.x, 0) || is_at(p.x, facts.view.width) || is_at(p.y, 0) || is_at(p.y, facts.view.height))
            return true;
    }
    return false;
}

/// May the triangle hold the place once its corners have moved by as much, in x and in y?
bool may_hold(const PieceCorners& corners, const glm::dvec2& p_raster, double moved_px) {
    const auto is_beside = [&](const glm::dvec2& normal) {
        const double at = dot(normal, p_raster), room = moved_px * (std::abs(normal.x) + std::abs(normal.y));
        double low = unlimited, high = -unlimited;
        for (const WindowCorner& c : corners) {
            const double along = normal.x * c.x + normal.y * c.y;
            low = std::min(low, along), high = std::max(high, along);
        }
        return at < low - room || at > high + room;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const WindowCorner &from = corners[i], &to = corners[(i + 1) % 3];
        if (is_beside({to.y - from.y, from.x - to.x})) return false;
    }
    return !is_beside({1, 0}) && !is_beside({0, 1});
}

}  // namespace

ValuePlanes value_planes(const RasterPrecision& precision, const Surface& s) {
    const View& view = s.facts.view;
    const RasterBounds raster(s.facts, precision);
    std::vector<WindowCorner> polygon =
        window_polygon(s.facts, s.extent, precision.clipping, z_range(view.camera, precision));
    const double drift = raster.drift_px(s.bounds, polygon);
    const bool is_cut_at_a_side = raster.clips_at_sides() && has_corner_at_a_side(s.facts, s.extent, drift);
    if (is_cut_at_a_corner(s.facts, s.extent, s.bounds) || is_cut_at_a_side) return {};
    for (WindowCorner& corner : polygon) corner.z = s.facts.perspective ? corner.inverse_depth : 1;
    const CornerShift shift{.snap_px = raster.snap_px(), .drift_px = drift};
    const glm::dvec2 p_raster = sampled_at(view, s.pixel.x, s.pixel.y);
    std::optional<ValuePlanes> worst;
    for_each_triangle(polygon, [&](const WindowCorner& p, const WindowCorner& q, const WindowCorner& r) {
        const PieceCorners piece{p, q, r};
        if (!may_hold(piece, p_raster, shift.snap_px + shift.drift_px)) return;
        const PlaneEquationBounds weights = plane_equation_bounds(piece, shift, view),
                                  values = plane_equation_bounds(piece, shift, view, CornerSigns::any);
        const ValuePlanes here{weights.z_error, values.z_error, weights.spread},
            before = worst.value_or(here);
        worst = {std::max(before.of_weights, here.of_weights), std::max(before.of_values, here.of_values),
                 std::max(before.spread, here.spread)};
    });
    return worst.value_or(ValuePlanes{});
}

}  // namespace zproof
