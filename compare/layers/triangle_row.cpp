#include "compare/layers/triangle_row.h"

#include <algorithm>
#include <cmath>

#include "compare/bounds/nearness_range.h"

// Kernels are compiled once per instruction set. No bit depends on which runs: contraction is off, and loops
// keep their order.

namespace zproof {

namespace {

[[gnu::target_clones("default", "avx2", "avx512f")]] void set_nearness(
    const KeptPlane plane, const std::array<TileRow, 3>& direction, TileRow& nearness) {
    for (std::size_t i = 0; i < tile_columns; ++i)
        nearness[i] = plane.nearness_at({direction[0][i], direction[1][i], direction[2][i]});
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void set_eps(const BoundsOnPlane bounds,
                                                                  const TileRow& nearness, TileRow& eps_px) {
    for (std::size_t i = 0; i < tile_columns; ++i) eps_px[i] = bounds.at(nearness[i]).eps_px;
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void set_directions(const Sights<double> sights,
                                                                         const RowPlace row,
                                                                         std::array<TileRow, 3>& direction) {
    for (int i = 0; i < int(tile_columns); ++i) {
        const Vector3<double> d = sights.direction_at(row.left + i, row.y);
        direction[0][std::size_t(i)] = d.x;
        direction[1][std::size_t(i)] = d.y;
        direction[2][std::size_t(i)] = d.z;
    }
}

/// What neighbour_of takes of a perspective's triangle whose plane is known, but for its nearness.
struct PlaneOfView {
    double gradient;
    PlaneError error;
    DepthLaw law;
    NearnessRange corners;  ///< any_nearness where the renderer does not keep to them
};

/// BoundsOnPlane::at for depth, without branches.
[[gnu::always_inline]] inline LocalBounds depth_bounds(const DepthLaw& law, double nearness) {
    const double here = held_between(nearness, law.least, law.highest);
    const double reach = (law.base + law.per * here) * law.amplification;
    const double varying = law.depth_factor + law.plane_offset / here;
    const double sum = law.plane_offset > 0 ? varying : law.depth_factor, relative = sum / (1 - sum);
    return {.eps_px = 0,
            .depth_eps_px = reach < law.most ? reach : law.most,
            .depth_relative = sum < 1 ? relative : unlimited,
            .depth_absolute = law.absolute,
            .nearness_error = law.nearness_error};
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void set_range(const PlaneOfView plane,
                                                                    const TileRow& nearness,
                                                                    TriangleRow::Range& row) {
    TileRow least, greatest;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const LocalBounds bounds = depth_bounds(plane.law, nearness[i]);
        const double error = plane.error.known_at(std::abs(nearness[i]) + plane.gradient);
        const NearnessRange all = rounded(
            on_plane({nearness[i], plane.gradient, error}, bounds, plane.corners, true), bounds, true);
        const double widening = bounds.depth_relative + bounds.depth_absolute + bounds.nearness_error;
        least[i] = widening < unlimited ? all.least : -unlimited;
        greatest[i] = widening < unlimited ? all.greatest : unlimited;
    }
    row = {least, greatest};
}

TriangleRow::Range ranges_one_by_one(const TriangleOfView& triangle, const SightRow& sight) {
    TriangleRow::Range row;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const NearnessRange range = nearness_range_of(sight.at(i), triangle);
        row.least[i] = range.least;
        row.greatest[i] = range.greatest;
    }
    return row;
}

}  // namespace

SightRow::SightRow(const Sights<double>& sights, const RowPlace& row) : sights_(&sights), row_(row) {
    set_directions(sights, row, direction_);
}

TileRow SightRow::nearness(const KeptPlane& plane) const {
    TileRow nearness;
    set_nearness(plane, direction_, nearness);
    return nearness;
}

TriangleRow::TriangleRow(const ImageOfView& image, const SightRow& sight)
    : sight_(&sight), plane_(image.kept_plane()) {
    if (plane_) nearness_ = sight.nearness(*plane_);
}

TileRow TriangleRow::eps_px(const TriangleOfView& triangle) const {
    TileRow eps_px;
    if (triangle.bounds.eps_per_nearness == 0)
        eps_px.fill(triangle.bounds.eps_base_px);
    else if (plane_)
        set_eps(*triangle.on_plane, nearness_, eps_px);
    else
        for (std::size_t i = 0; i < tile_columns; ++i) eps_px[i] = triangle.eps_px(sight_->at(i));
    return eps_px;
}

auto TriangleRow::nearness_range(const TriangleOfView& triangle) const -> Range {
    if (!plane_ || !triangle.seen->plane_error.is_known()) return ranges_one_by_one(triangle, *sight_);
    Range range;
    const TriangleBounds& b = triangle.bounds;
    const PlaneOfView plane{
        .gradient = plane_->gradient,
        .error = triangle.seen->plane_error,
        .law = triangle.on_plane->depth_law(),
        .corners = triangle.keeps_to_corners ? NearnessRange{1 / b.farthest, 1 / b.nearest} : any_nearness};
    set_range(plane, nearness_, range);
    return range;
}

}  // namespace zproof
