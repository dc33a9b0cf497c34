#include "compare/triangle_row.h"

#include <algorithm>
#include <cmath>

#include "compare/nearness_range.h"

namespace zproof {

namespace {

using Flags = LanesOf<std::uint64_t>;  ///< 0 or 1

LaneMask packed(const Flags& flags) {
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < lane_count; ++i) mask |= flags[i] << i;
    return LaneMask(mask);
}

/// Compiled once per instruction set. No bit depends on which runs: contraction is off, and the loops keep
/// their order.
[[gnu::target_clones("default", "avx2", "avx512f")]] PlaceMasks places(const TriangleFilter& filter,
                                                                       const LaneRow& row,
                                                                       double half_side_px) {
    Flags misses{}, inside;
    inside.fill(1);
    for (const Affine<double>& e : filter.edge) {
        const double reach = half_side_px * std::abs(e.a) + half_side_px * std::abs(e.b) + filter.edge_error;
        const double along_column = e.b * row.y;
        for (std::size_t i = 0; i < lane_count; ++i) {
            const double middle = e.a * double(row.left + int(i)) + along_column + e.c;
            misses[i] |= std::uint64_t(middle + reach < 0);
            inside[i] &= std::uint64_t(middle - reach > 0);
        }
    }
    Flags covers, cuts;
    for (std::size_t i = 0; i < lane_count; ++i) {
        covers[i] = inside[i] & ~misses[i];
        cuts[i] = 1 & ~inside[i] & ~misses[i];
    }
    return {packed(covers), packed(cuts)};
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void set_nearness(const KeptPlane plane,
                                                                       const std::array<Lanes, 3>& direction,
                                                                       Lanes& nearness) {
    for (std::size_t i = 0; i < lane_count; ++i)
        nearness[i] = plane.nearness_at({direction[0][i], direction[1][i], direction[2][i]});
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void set_eps(const BoundsOnPlane bounds,
                                                                  const Lanes& nearness, Lanes& eps_px) {
    for (std::size_t i = 0; i < lane_count; ++i) eps_px[i] = bounds.at(nearness[i]).eps_px;
}

/// What neighbour_of takes of a perspective's triangle, but for its nearness.
struct PlaneOfView {
    double gradient;
    PlaneError error;
    BoundsOnPlane bounds;
    NearnessRange corners;
    bool keeps_to_corners;
};

[[gnu::target_clones("default", "avx2", "avx512f")]] void set_range(const PlaneOfView plane, const Lanes& nearness,
                                                                    NearnessRow& row) {
    for (std::size_t i = 0; i < lane_count; ++i) {
        const LocalBounds bounds = plane.bounds.at(nearness[i]);
        const double error = plane.error.at(std::abs(nearness[i]) + plane.gradient);
        const NearnessRange all = rounded(
            on_plane({nearness[i], plane.gradient, error}, bounds, plane.corners, plane.keeps_to_corners),
            bounds, true);
        const double known = plane.keeps_to_corners ? 0 : error;
        const double widening = bounds.depth_relative + bounds.depth_absolute + bounds.nearness_error;
        const bool is_bounded = (widening < unlimited) & (known < unlimited);
        row.least[i] = is_bounded ? all.least : -unlimited;
        row.greatest[i] = is_bounded ? all.greatest : unlimited;
    }
}

NearnessRow ranges_one_by_one(const TriangleOfView& triangle, const SightRow& sight) {
    NearnessRow row;
    for (std::size_t i = 0; i < lane_count; ++i) {
        const Neighbour n = neighbour_of(sight.at(i), triangle);
        row.least[i] = n.least_nearness;
        row.greatest[i] = n.greatest_nearness;
    }
    return row;
}

Lanes nearness_of(const KeptPlane& plane, const SightRow& sight) {
    Lanes nearness;
    set_nearness(plane, sight.direction(), nearness);
    return nearness;
}

}  // namespace

SightRow::SightRow(const Sights<double>& sights, const LaneRow& row) : sights_(&sights), row_(row) {
    for (std::size_t i = 0; i < lane_count; ++i) {
        const Vector3<double> direction = at(i).direction;
        direction_[0][i] = direction.x;
        direction_[1][i] = direction.y;
        direction_[2][i] = direction.z;
    }
}

PlaceMasks places_in_row(const TriangleFilter& filter, const LaneRow& row, double half_side_px) {
    return places(filter, row, half_side_px);
}

Lanes eps_px_in_row(const TriangleOfView& triangle, const SightRow& sight) {
    Lanes eps_px;
    const std::optional<KeptPlane> plane = triangle.image.kept_plane();
    if (triangle.bounds.eps_per_nearness == 0)
        eps_px.fill(triangle.bounds.eps_base_px);
    else if (plane)
        set_eps(*triangle.on_plane, nearness_of(*plane, sight), eps_px);
    else
        for (std::size_t i = 0; i < lane_count; ++i) eps_px[i] = triangle.eps_px(sight.at(i));
    return eps_px;
}

NearnessRow nearness_in_row(const TriangleOfView& triangle, const SightRow& sight) {
    const std::optional<KeptPlane> kept = triangle.image.kept_plane();
    if (!kept) return ranges_one_by_one(triangle, sight);
    NearnessRow row;
    const TriangleBounds& b = triangle.bounds;
    const PlaneOfView plane{.gradient = kept->gradient,
                      .error = triangle.plane_error,
                      .bounds = *triangle.on_plane,
                      .corners = {1 / b.farthest, 1 / b.nearest},
                      .keeps_to_corners = triangle.keeps_to_corners};
    set_range(plane, nearness_of(*kept, sight), row);
    return row;
}

}  // namespace zproof
