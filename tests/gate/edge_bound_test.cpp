/// eps is neither padded nor broken: what the suite's edges need of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compare/admissible/neighbourhood.h"
#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/pipeline.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "tests/gate/suite_verdict.h"

namespace zproof {
namespace {

using real = long double;

struct Point {
    real x, y;  ///< raster space, px
};

real dot(const glm::dvec3& axis, const glm::dvec3& v) {
    return real(axis.x) * v.x + real(axis.y) * v.y + real(axis.z) * v.z;
}

/// Nothing in front of the near plane.
std::optional<Point> to_raster(const View& view, const glm::vec3& p_world) {
    const Camera& c = view.camera;
    const glm::dvec3 v = glm::dvec3(p_world) - glm::dvec3(c.eye_world);
    const real depth = -dot(c.back, v);
    if (!(depth >= c.near_depth)) return std::nullopt;
    const bool perspective = c.projection == Projection::perspective;
    const real u = perspective ? dot(c.right, v) / depth : dot(c.right, v) - c.shear.x * depth;
    const real w = perspective ? dot(c.up, v) / depth : dot(c.up, v) - c.shear.y * depth;
    return Point{(u - c.window.left) / (c.window.right - c.window.left) * view.width,
                 (c.window.top - w) / (c.window.top - c.window.bottom) * view.height};
}

/// How far, in x and in y at once, the line from a to b would have to move to the right of its way (y down)
/// to meet p; negative where p lies there already.
real miss_of_line(const Point& p, const Point& a, const Point& b) {
    const real dx = b.x - a.x, dy = b.y - a.y;
    return (dy * (p.x - a.x) - dx * (p.y - a.y)) / (std::abs(dx) + std::abs(dy));
}

/// How far, in x and in y, the triangle's edges would have to move out to hold the pixel's centre; nothing
/// where near may cut it.
std::optional<real> miss_of_triangle(const Scene& scene, const View& view, PrimitiveId id, int x, int y) {
    std::array<Point, 3> p{};
    const CornersWorld p_world = corners_of(scene, std::uint32_t(id));
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<Point> corner = to_raster(view, p_world[i]);
        if (!corner) return std::nullopt;
        p[i] = *corner;
    }
    if ((p[1].x - p[0].x) * (p[2].y - p[0].y) < (p[1].y - p[0].y) * (p[2].x - p[0].x)) std::swap(p[1], p[2]);
    const Point centre{x + real(0.5), y + real(0.5)};
    return std::max({miss_of_line(centre, p[0], p[1]), miss_of_line(centre, p[1], p[2]),
                     miss_of_line(centre, p[2], p[0])});
}

/// The largest share of its own eps that any triangle answered on an edge misses its pixel's centre by.
double largest_miss_over_own_eps(const Scene& scene, const View& view, const ViewBounds& bounds,
                                 const Verdict& verdict) {
    double largest = 0;
    for (const Finding& f : verdict.findings) {
        const PrimitiveId id = f.candidate.primitive;
        if (f.verdict != PixelClass::edge || id == PrimitiveId::none) continue;
        if (const auto miss = miss_of_triangle(scene, view, id, f.x, f.y))
            largest = std::max(largest, double(*miss / own_eps_px(scene, view, bounds, {f.x, f.y}, id)));
    }
    return largest;
}

class EdgeBound : public testing::TestWithParam<std::string> {};

TEST_P(EdgeBound, IsNeededByMoreThanHalfAndNeverByMoreThanAll) {
    const Loaded loaded = generate_suite_scene(GetParam(), 960, 540);
    const oracle::Embree embree(loaded.scene);
    double largest = 0;
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        const Frame candidate = rasterizer::render(loaded.scene, view), reference = embree.trace(view);
        const Verdict verdict = judge(loaded.scene, view, {candidate, rasterizer::precision()},
                                      {reference, oracle::embree_precision()}, full_detail);
        EXPECT_LE(verdict.candidate_edges.max_error_over_bound, 1);
        EXPECT_LE(verdict.reference_edges.max_error_over_bound, 1);
        const ViewBounds bounds(view, rasterizer::precision());
        EXPECT_LE(largest_miss_over_own_eps(loaded.scene, view, bounds, verdict), 1);
        largest = std::max(largest, verdict.candidate_edges.max_error_over_bound);
    }
    EXPECT_GT(largest, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Suite, EdgeBound,
                         testing::Values("textured_ground", "deep_overdraw", "slivers", "t_junctions",
                                         "far_from_origin", "depth_range", "oblique"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
