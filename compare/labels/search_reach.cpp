#include "compare/labels/search_reach.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compare/adjudicate/unproven_pixels.h"
#include "compare/admissible/neighbourhood.h"
#include "compare/admissible/weights.h"

namespace zproof {

namespace {

/// Triangles whose eps is below this everywhere are found by any search. It costs or saves time and changes
/// no answer.
constexpr double least_px = 1.0 / 16;

}  // namespace

SearchReach::SearchReach(const Scene& scene, const View& view, const ViewBounds& bounds)
    : scene_(scene), view_(view), bounds_(bounds) {
    const BoxProjection projection(view);
    const ViewRay<double> first_pixel(view, 0, 0);
    tbb::enumerable_thread_specific<std::vector<Wide>> found;
    tbb::enumerable_thread_specific<std::vector<Thin>> found_thin;
    tbb::parallel_for(std::size_t(0), scene.triangles.size(), [&](std::size_t t) {
        const CornersWorld p_world = corners_of(scene, std::uint32_t(t));
        const TriangleBounds here = bounds.of(p_world);
        const double most_px = here.most_eps_px();
        if (here.may_be_shown_by_rounding() &&
            (here.weight_tolerance > 0 ||
             beyond_corners_px(edges_of(first_pixel, corners<double>(p_world)), most_px) > least_px))
            found_thin.local().push_back(thin_of(std::uint32_t(t)));
        if (most_px <= least_px) return;
        if (const Box box = projection.before_eye(p_world); !box.is_empty())
            found.local().push_back({std::uint32_t(t), most_px, box});
    });
    for (const auto& some : found) wide_.insert(wide_.end(), some.begin(), some.end());
    tbb::parallel_sort(wide_, [](const Wide& a, const Wide& b) {
        return std::tie(b.most_px, a.triangle) < std::tie(a.most_px, b.triangle);
    });
    for (const auto& some : found_thin) thin_.insert(thin_.end(), some.begin(), some.end());
    tbb::parallel_sort(thin_, [](const Thin& a, const Thin& b) { return a.triangle < b.triangle; });
}

/// docs/labels.md says why that is far enough. 2: TileWork asks as far as twice an answer's eps whose eps
/// counts.
double SearchReach::at(const PixelCoord& pixel) const {
    double reach_px = least_px;
    for (const Wide& wide : wide_) {
        if (wide.most_px <= reach_px) break;
        if (!wide.box.meets(square_around(pixel.x, pixel.y, 2 * wide.most_px))) continue;
        const double eps_px = own_eps_px(scene_, view_, bounds_, pixel, PrimitiveId(wide.triangle));
        if (wide.box.meets(square_around(pixel.x, pixel.y, 2 * eps_px)))
            reach_px = std::max(reach_px, eps_px);
    }
    return reach_px;
}

/// Margins are those of is_inside_by_rounding(), and what double errs by anywhere in the image.
SearchReach::Thin SearchReach::thin_of(std::uint32_t triangle) const {
    const ViewRay<double> ray(view_, 0, 0);
    const BoundedTriangle bounded(bounds_, corners_of(scene_, triangle));
    const Neighbour n = neighbour_of(ray, bounded);
    const double tolerance = n.weight_tolerance, eps_px = bounded.bounds.most_eps_px();
    const auto weights = weights_of(ray, n);
    const Affine<double> sum = weights[0] + weights[1] + weights[2];
    double depth = 1;  // weights may be edges times it
    for (const Vector3<double>& p : corners<double>(n.p_world))
        depth = std::max(depth, std::abs(camera_depth(ray, p - ray.origin)));
    const double error = n.edge_error * depth * (1 + 3 * tolerance) * (view_.width + view_.height);
    Thin thin{triangle, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Affine<double>& f = thin.edges[i] = weights[i] + tolerance * sum;
        thin.margins[i] = n.edge_rounding_px[i] * (std::abs(weights[i].a) + std::abs(weights[i].b)) +
                          eps_px * (std::abs(f.a) + std::abs(f.b)) + error;
    }
    return thin;
}

std::vector<std::uint32_t> SearchReach::shown_by_rounding(const PixelCoord& pixel) const {
    std::vector<std::uint32_t> shown;
    for (const Thin& thin : thin_) {
        bool is_inside = true, is_inside_turned = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const double here = thin.edges[i].at(pixel.x, pixel.y);
            is_inside &= !(here < -thin.margins[i]);
            is_inside_turned &= !(here > thin.margins[i]);
        }
        if (is_inside || is_inside_turned) shown.push_back(thin.triangle);
    }
    return shown;
}

}  // namespace zproof
