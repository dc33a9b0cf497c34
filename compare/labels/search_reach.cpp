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

/// How far g's slope is turned from f's, times both.
double turn_between(const Affine<double>& f, const Affine<double>& g) { return f.a * g.b - g.a * f.b; }

/// The box around the place where both functionals have these values; unlimited where double tells it badly.
Box box_of_crossing(const Affine<double>& f, double of_f, const Affine<double>& g, double of_g) {
    const double turn = turn_between(f, g), slopes = std::hypot(f.a, f.b) * std::hypot(g.a, g.b);
    if (!(std::abs(turn) > 1e-6 * slopes)) return Box::unlimited();
    const double p = of_f - f.c, q = of_g - g.c;
    Box box;
    box.add((p * g.b - q * f.b) / turn, (f.a * q - g.a * p) / turn);
    return box;
}

}  // namespace

SearchReach::SearchReach(const Scene& scene, const View& view, const ViewBounds& bounds)
    : scene_(scene), view_(view), bounds_(bounds), tiles_(view) {
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
    sort_by_tile();
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

bool SearchReach::Thin::may_show(const PixelCoord& pixel) const {
    bool is_inside = true, is_inside_turned = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const double here = edges[i].at(pixel.x, pixel.y);
        is_inside &= !(here < -margins[i]);
        is_inside_turned &= !(here > margins[i]);
    }
    return is_inside || is_inside_turned;
}

/// Three half planes whose slopes turn one way all round leave a triangle, or nothing: its corners are where
/// two of the lines cross.
Box SearchReach::Thin::box() const {
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const bool turns_on = turn_between(edges[i], edges[j]) * turn_between(edges[j], edges[k]) > 0;
        if (!turns_on) return Box::unlimited();
        for (const double side : {-1.0, 1.0})
            box.add(box_of_crossing(edges[i], side * margins[i], edges[j], side * margins[j]));
    }
    box.widen(1);  // far more than double errs by where slopes turn by a millionth
    return box;
}

void SearchReach::sort_by_tile() {
    constexpr double most_px = 1 << 10;  // wider ones are asked about at every pixel
    thin_by_tile_.resize(tiles_.count());
    for (std::uint32_t place = 0; place < thin_.size(); ++place) {
        const Box box = thin_[place].box();
        if (!(box.right - box.left < most_px && box.bottom - box.top < most_px)) {
            thin_anywhere_.push_back(place);
            continue;
        }
        const auto tile_at = [](double x, int count) {
            return int(std::clamp(std::floor(x / Tiles::side_px), 0.0, double(count)));
        };
        for (int row = tile_at(box.top, tiles_.rows); row < tile_at(box.bottom, tiles_.rows - 1) + 1; ++row)
            for (int column = tile_at(box.left, tiles_.columns);
                 column < tile_at(box.right, tiles_.columns - 1) + 1; ++column)
                thin_by_tile_[tiles_.index(column, row)].push_back(place);
    }
}

std::vector<std::uint32_t> SearchReach::shown_by_rounding(const PixelCoord& pixel) const {
    std::vector<std::uint32_t> shown;
    for (const auto* places : {&thin_by_tile_[tiles_.of(pixel.x, pixel.y)], &thin_anywhere_})
        for (const std::uint32_t place : *places)
            if (thin_[place].may_show(pixel)) shown.push_back(thin_[place].triangle);
    std::ranges::sort(shown);
    return shown;
}

}  // namespace zproof
