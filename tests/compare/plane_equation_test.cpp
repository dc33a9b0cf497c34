/// Does the bound of a plane equation bound? Random triangles are interpolated in float32, step by step, and
/// held against their planes in double, whose own error is 2^29 times smaller.
#include "compare/bounds/plane_equation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "random_surroundings.h"

namespace zproof {
namespace {

constexpr double snap = 0x1p-9;

View wide_view() { return {.name = "wide", .camera = {}, .width = 1920, .height = 1080}; }

/// The z of a pixel's centre as a driver computes it: gradients by Cramer's rule, then an offset at the
/// window's corner.
float interpolated(const std::array<WindowCorner, 3>& p, int x, int y) {
    const auto xf = [&](std::size_t i) { return float(p[i].x); };
    const auto yf = [&](std::size_t i) { return float(p[i].y); };
    const auto zf = [&](std::size_t i) { return float(p[i].z); };
    const float dx01 = xf(0) - xf(1), dy01 = yf(0) - yf(1), dx20 = xf(2) - xf(0), dy20 = yf(2) - yf(0);
    const float one_over_area = 1 / (dx01 * dy20 - dx20 * dy01);
    const float dz01 = zf(0) - zf(1), dz20 = zf(2) - zf(0);
    const float dzdx = dz01 * (dy20 * one_over_area) - dz20 * (dy01 * one_over_area);
    const float dzdy = dz20 * (dx01 * one_over_area) - dz01 * (dx20 * one_over_area);
    const float at_origin = zf(0) - (dzdx * (xf(0) - 0.5f) + dzdy * (yf(0) - 0.5f));
    return (at_origin + dzdx * float(x)) + dzdy * float(y);
}

/// Twice the signed area of p, q and the point.
double area(const WindowCorner& p, const WindowCorner& q, double x, double y) {
    return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
}

/// z of the triangle's plane at the pixel's centre; none where the centre is outside.
std::optional<double> true_z(const std::array<WindowCorner, 3>& p, int x, int y) {
    double z = 0;
    const double whole = area(p[0], p[1], p[2].x, p[2].y);
    for (std::size_t i = 0; i < 3; ++i) {
        const double b = area(p[(i + 1) % 3], p[(i + 2) % 3], x + 0.5, y + 0.5) / whole;
        if (!(b >= 0)) return std::nullopt;
        z += b * p[i].z;
    }
    return z;
}

/// Corners that float32 holds, of triangles from a pixel to the whole image, some of them thin; each z is off
/// by what division and viewport may cost.
std::array<WindowCorner, 3> random_corners(Rng& rng, CornerSigns signs,
                                           std::array<WindowCorner, 3>& rounded) {
    const View view = wide_view();
    const double size = std::exp2(rng.between(0, 10)), thin = std::exp2(-rng.between(0, 8));
    const double x = rng.between(0, view.width), y = rng.between(0, view.height);
    std::array<WindowCorner, 3> exact;
    for (std::size_t i = 0; i < 3; ++i) {
        const double across = rng.between(-size, size);
        exact[i] = {float(x + across), float(y + rng.between(-size, size) * thin + across),
                    rng.between(0.01, 1)};
        if (signs == CornerSigns::any && rng.below(2) == 1) exact[i].z *= -1;
        rounded[i] = exact[i];
        rounded[i].z = float(exact[i].z * (1 + rng.between(-3, 3) * 0x1p-24));
    }
    return exact;
}

double largest_share(CornerSigns signs, double* largest_bound) {
    double largest = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        Rng rng(seed);
        std::array<WindowCorner, 3> rounded;
        const auto exact = random_corners(rng, signs, rounded);
        auto sizes = exact;
        for (WindowCorner& corner : sizes) corner.z = std::abs(corner.z);
        const double bound =
            plane_equation_bounds(sizes, {.snap_px = snap, .drift_px = 0}, wide_view(), signs).z_error;
        if (!std::isfinite(bound)) continue;
        *largest_bound = std::max(*largest_bound, bound);
        for (int k = 0; k < 200; ++k) {
            const int x = int(exact[0].x + rng.between(-1, 1) * (exact[1].x - exact[0].x));
            const int y = int(exact[0].y + rng.between(-1, 1) * (exact[2].y - exact[0].y));
            if (const auto z = true_z(exact, x, y))
                largest = std::max(largest, std::abs(interpolated(rounded, x, y) - *z) / bound);
        }
    }
    return largest;
}

TEST(PlaneEquation, NoFloat32PlaneErrsByMoreThanItsBoundAndSomeErrByAShareOfIt) {
    for (const CornerSigns signs : {CornerSigns::known, CornerSigns::any}) {
        double largest_bound = 0;
        const double share = largest_share(signs, &largest_bound);
        EXPECT_LE(share, 1);
        EXPECT_GT(share, signs == CornerSigns::known ? 0.1 : 0.05);
        EXPECT_LT(largest_bound, 1e30);
    }
}

/// A sliver through the pixel's centre; its corners as they are, and on the grid.
std::array<std::array<WindowCorner, 3>, 2> random_sliver(Rng& rng, int x, int y) {
    const double size = std::exp2(rng.between(0, 10)), turn = rng.between(0, 6.3),
                 height = std::exp2(-rng.between(0, 9)) / 3;
    const double along[] = {-size, size, rng.between(-size, size)}, across[] = {-height, -height, 2 * height};
    const auto on_grid = [](double px) { return std::nearbyint(px * 256) / 256; };
    std::array<std::array<WindowCorner, 3>, 2> both;
    for (std::size_t i = 0; i < 3; ++i) {
        const double u = along[i] * std::cos(turn) - across[i] * std::sin(turn),
                     v = along[i] * std::sin(turn) + across[i] * std::cos(turn);
        both[0][i] = {float(x + 0.5 + u), float(y + 0.5 + v), float(rng.between(0.01, 1))};
        both[1][i] = {on_grid(both[0][i].x), on_grid(both[0][i].y), both[0][i].z};
    }
    return both;
}

/// Beside the plane of the snapped corners, which lies within their displacement.
TEST(PlaneEquation, NoneOfSnappedCornersErrsByMoreOnSlivers) {
    int judged = 0;
    for (std::uint32_t seed = 0; seed < 100'000; ++seed) {
        Rng rng(seed);
        const int x = int(rng.between(100, 1800)), y = int(rng.between(100, 1000));
        const auto [corners, on_grid] = random_sliver(rng, x, y);
        const auto z = true_z(on_grid, x, y);
        const double bound = plane_equation_bounds(corners, {snap, 0}, wide_view()).z_error;
        if (!z || !std::isfinite(bound)) continue;
        ++judged;
        EXPECT_LE(std::abs(interpolated(on_grid, x, y) - *z), bound) << seed;
    }
    EXPECT_GT(judged, 50'000);
}

TEST(PlaneEquation, OfThreeCornersOnALineNothingIsKnown) {
    const std::array<WindowCorner, 3> line{WindowCorner{0, 0, 0.5}, {10, 10, 0.6}, {30, 30, 0.7}};
    EXPECT_EQ(plane_equation_bounds(line, {snap, 1e-4}, wide_view()).z_error, unlimited);
    EXPECT_EQ(plane_equation_bounds(std::span(line).first(2), {snap, 1e-4}, wide_view()).z_error, unlimited);
}

/// A triangle whose corners may drift onto a line is as unknown as one whose corners lie on it.
TEST(PlaneEquation, DriftUntilAThinTriangleMayVanishMakesItUnknown) {
    const std::array<WindowCorner, 3> thin{WindowCorner{0, 0, 0.5}, {1000, 0, 0.6}, {500, 0.01, 0.7}};
    EXPECT_LT(plane_equation_bounds(thin, {snap, 1e-5}, wide_view()).z_error, unlimited);
    EXPECT_EQ(plane_equation_bounds(thin, {snap, 1e-2}, wide_view()).z_error, unlimited);
}

TEST(PlaneEquation, APolygonIsAsBadAsItsThinnestThreeCorners) {
    const std::array<WindowCorner, 4> quad{
        WindowCorner{0, 0, 0.1}, {100, 0, 0.2}, {100, 0.01, 0.2}, {0, 100, 0.4}};
    const auto whole = plane_equation_bounds(quad, {snap, 1e-6}, wide_view());
    const std::array<WindowCorner, 3> thin{quad[1], quad[2], quad[3]};
    EXPECT_EQ(whole.z_error, plane_equation_bounds(thin, {snap, 1e-6}, wide_view()).z_error);
    const std::array<WindowCorner, 3> plain{quad[0], quad[1], quad[3]};
    EXPECT_GT(whole.z_error, 10 * plane_equation_bounds(plain, {snap, 1e-6}, wide_view()).z_error);
}

/// The camera's window is [-1, 1]^2 at depth 1, near is at 0.1.
std::vector<WindowCorner> seen(const CornersWorld& p) {
    const View view = wide_view();
    const ViewFacts facts(view);
    return window_polygon(facts, facts.extent_of(p), Clipping::view_volume,
                          z_range(view.camera, {.depth_buffer = DepthBuffer::reversed_z}));
}

TEST(WindowPolygon, KeepsATriangleInsideAsItIs) {
    const auto polygon = seen({glm::vec3{0, 0, -2}, {1, 0, -2}, {0, 1, -4}});
    ASSERT_EQ(polygon.size(), 3u);
    EXPECT_EQ(polygon[1].x, 1440);
    EXPECT_EQ(polygon[1].y, 540);
    EXPECT_EQ(polygon[2].y, 405);
    EXPECT_DOUBLE_EQ(polygon[2].z, 0.1 / 4);
}

TEST(WindowPolygon, HasNewCornersAtNearAndAtTheWindowsSides) {
    const auto at_near = seen({glm::vec3{0, 0, -2}, {0.1f, 0, -2}, {0, 0.01f, 1}});
    ASSERT_EQ(at_near.size(), 4u);
    EXPECT_EQ(std::ranges::count_if(at_near, [](const auto& c) { return std::abs(c.z - 1) < 1e-12; }), 2);
    const auto wall = seen({glm::vec3{-90, -90, -2}, {90, -90, -2}, {0, 90, -2}});
    EXPECT_EQ(wall.size(), 4u) << "the whole window";
    for (const WindowCorner& corner : wall) EXPECT_TRUE(corner.x == 0 || corner.x == 1920) << corner.x;
    EXPECT_TRUE(seen({glm::vec3{0, 0, 2}, {1, 0, 2}, {0, 1, 4}}).empty());
}

}  // namespace
}  // namespace zproof
