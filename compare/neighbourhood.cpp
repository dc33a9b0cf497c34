#include "compare/neighbourhood.h"

#include <algorithm>
#include <cmath>

namespace zproof {

namespace {

double steepness(const Affine<double>& f) { return std::abs(f.a) + std::abs(f.b); }

/// [least, greatest] from the plane's slope over eps, kept to the corners where the renderer keeps to them,
/// then rounded. An estimate in double of numbers that are bounds themselves.
void set_nearness_range(Neighbour& n, const std::optional<TriangleImage<double>>& image,
                        const PlaneSize& size, Projection projection, bool keeps_to_corners) {
    const bool perspective = projection == Projection::perspective;
    double least = perspective ? 1 / n.farthest : -n.farthest,
           greatest = perspective ? 1 / n.nearest : -n.nearest;
    if (image) {
        const double error = size.nearness_error(std::abs(image->nearness.c) + n.gradient);
        n.is_plane_known = std::isfinite(error);
        const double shift = n.bounds.depth_eps_px * (n.gradient + error) + error + n.bounds.nearness_error;
        const double low = image->nearness.c - shift, high = image->nearness.c + shift;
        least = keeps_to_corners ? std::clamp(low, least, greatest) : low;
        greatest = keeps_to_corners ? std::clamp(high, least, greatest) : high;
    }
    const double r = n.bounds.depth_relative, a = n.bounds.depth_absolute;
    if (!std::isfinite(r + a + n.bounds.nearness_error) || (!n.is_plane_known && !keeps_to_corners)) {
        n.least_nearness = -unlimited;
        n.greatest_nearness = unlimited;
    } else if (perspective) {
        const double share = r + a * std::abs(greatest);
        n.least_nearness = least - std::abs(least) * (r + a * std::abs(least));
        n.greatest_nearness = share < 1 ? greatest + std::abs(greatest) * share / (1 - share) : unlimited;
    } else {
        n.least_nearness = least - std::abs(least) * r - a;
        n.greatest_nearness = greatest + std::abs(greatest) * r + a;
    }
}

/// Does the image come within eps of the centre? An estimate in double: it only decides whose eps counts.
bool comes_within(const TriangleImage<double>& image, double eps_px) {
    return std::ranges::all_of(image.edge,
                               [&](const Affine<double>& e) { return e.c + eps_px * steepness(e) >= 0; });
}

}  // namespace

std::optional<std::size_t> Neighbourhood::index_of(PrimitiveId triangle) const {
    const auto found = std::ranges::find(neighbours, std::uint32_t(triangle), &Neighbour::triangle);
    if (found == neighbours.end()) return std::nullopt;
    return std::size_t(found - neighbours.begin());
}

CornersWorld corners_of(const Scene& scene, std::uint32_t triangle) {
    const glm::uvec3 index = scene.triangles[triangle];
    const auto& p = scene.vertices.position_world;
    return {p[index.x], p[index.y], p[index.z]};
}

Neighbour neighbour_of(const Sight<double>& sight, const ViewBounds& bounds, const CornersWorld& p_world) {
    Neighbour n;
    n.p_world = p_world;
    const TriangleExtent extent = bounds.extent_of(p_world);
    const TriangleBounds of_triangle = bounds.of(extent);
    const auto image = image_of(sight, corners<double>(p_world));
    const double highest = of_triangle.nearest > 0 ? 1 / of_triangle.nearest : 0;
    if (image) n.gradient = steepness(image->nearness);
    n.bounds = of_triangle.at(image ? image->nearness.c : highest, n.gradient);
    n.near_slack = of_triangle.near_slack;
    n.far_slack = of_triangle.far_slack;
    n.nearest = of_triangle.nearest;
    n.farthest = of_triangle.farthest;
    set_nearness_range(n, image, extent.plane_size, sight.projection, bounds.keeps_to_corners());
    return n;
}

Neighbourhood neighbourhood_of(const Scene& scene, const View& view, const ViewBounds& bounds,
                               const Site& site, double own_eps_px) {
    const Sight<double> sight(view, site.x, site.y);
    Neighbourhood n{view, site.x, site.y, own_eps_px, {}};
    for (const std::uint32_t triangle : site.triangles) {
        Neighbour& last = n.neighbours.emplace_back(neighbour_of(sight, bounds, corners_of(scene, triangle)));
        last.triangle = triangle;
        const auto image = image_of(sight, corners<double>(last.p_world));
        if (image && comes_within(*image, own_eps_px)) n.eps_px = std::max(n.eps_px, last.bounds.eps_px);
    }
    return n;
}

double own_eps_px(const Scene& scene, const View& view, const ViewBounds& bounds, int x, int y,
                  PrimitiveId answer) {
    if (answer == PrimitiveId::none) return bounds.background_eps_px();
    return neighbour_of(Sight<double>(view, x, y), bounds, corners_of(scene, std::uint32_t(answer)))
        .bounds.eps_px;
}

}  // namespace zproof
