#include "compare/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/rounding.h"

namespace zproof {

namespace {

double steepness(const Affine<double>& f) { return std::abs(f.a) + std::abs(f.b); }

/// Forward error of the nearness at the centre, computed in double: see TriangleDepth.
double own_error(const PlaneSize& size, double nearness) {
    const double u = gamma(16, unit_roundoff_float64), condition = size.volume_abs / size.volume;
    return u * condition < 0.5 ? 2 * u * (size.numerator_abs / size.volume + std::abs(nearness) * condition)
                               : std::numeric_limits<double>::infinity();
}

/// [least, greatest] from the plane's slope over eps, kept to the corners where the renderer keeps to them,
/// then rounded. An estimate in double of numbers that are bounds themselves.
void set_nearness_range(Neighbour& n, const std::optional<TriangleImage<double>>& image,
                        const PlaneSize& size, Projection projection, bool keeps_to_corners) {
    const bool perspective = projection == Projection::perspective;
    double least = perspective ? 1 / n.farthest : -n.farthest,
           greatest = perspective ? 1 / n.nearest : -n.nearest;
    if (image) {
        const double shift = n.bounds.depth_eps_px * n.gradient + own_error(size, image->nearness.c);
        const double low = image->nearness.c - shift, high = image->nearness.c + shift;
        least = keeps_to_corners ? std::clamp(low, least, greatest) : low;
        greatest = keeps_to_corners ? std::clamp(high, least, greatest) : high;
    }
    const double r = n.bounds.depth_relative, a = n.bounds.depth_absolute;
    const auto error = [&](double nearness) {
        return perspective ? std::abs(nearness) * (r + a * std::abs(nearness)) : std::abs(nearness) * r + a;
    };
    n.least_nearness = least - error(least);
    n.greatest_nearness = greatest + error(greatest);
}

/// Does the image come within eps of the centre? An estimate in double: it only decides whose eps counts.
bool comes_within(const TriangleImage<double>& image, double eps_px) {
    return std::ranges::all_of(image.edge,
                               [&](const Affine<double>& e) { return e.c + eps_px * steepness(e) >= 0; });
}

}  // namespace

CornersWorld corners_of(const Scene& scene, std::uint32_t triangle) {
    const glm::uvec3 index = scene.triangles[triangle];
    const auto& p = scene.vertices.position_world;
    return {p[index.x], p[index.y], p[index.z]};
}

Neighbour neighbour_of(const Sight<double>& sight, const ViewBounds& bounds, const CornersWorld& p_world) {
    Neighbour n;
    n.p_world = p_world;
    const TriangleBounds of_triangle = bounds.of(p_world);
    const auto image = image_of(sight, corners<double>(p_world));
    const double highest = of_triangle.nearest > 0 ? 1 / of_triangle.nearest : 0;
    if (image) n.gradient = steepness(image->nearness);
    n.bounds = of_triangle.at(image ? image->nearness.c : highest, n.gradient);
    n.near_slack = of_triangle.near_slack;
    n.far_slack = of_triangle.far_slack;
    n.nearest = of_triangle.nearest;
    n.farthest = of_triangle.farthest;
    set_nearness_range(n, image, of_triangle.plane_size, sight.projection, bounds.keeps_to_corners());
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
