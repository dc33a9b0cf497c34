#include "compare/bounds/triangle_depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/admissible/depth_rule.h"
#include "compare/agree/depth_errors.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

/// Admissible by the formula of docs/bounds.md, all in rationals: within the plane's depths over the
/// displacement, and (rasterizers) within the corners' depths, each with its rounding.
bool admissible_in_rationals(const Surroundings& s, const ViewBounds& bounds, const CornersWorld& p,
                             float depth) {
    const Neighbour n = neighbour_of(ViewRay<double>(s.view, s.x, s.y), bounds, p);
    const auto image = image_of(ViewRay<Rational>(s.view, s.x, s.y), corners<Rational>(p));
    const Rational z{double(depth)}, r(n.bounds.depth_relative), a(n.bounds.depth_absolute), one(1);
    if (!image)
        return z + a >= Rational(n.nearest) - abs(Rational(n.nearest)) * r &&
               z - a <= Rational(n.farthest) + abs(Rational(n.farthest)) * r;
    const Affine<Rational>& plane = image->inverse_depth;
    const Rational shift = Rational(n.bounds.depth_eps_px) * (abs(plane.a) + abs(plane.b)), w = plane.c;
    if (s.view.camera.projection == Projection::parallel)
        return z + a >= -w - shift - abs(w + shift) * r && z - a <= shift - w + abs(shift - w) * r;
    if (w + shift <= 0) return false;
    return z + a >= (one - r) / (w + shift) && (w - shift <= 0 || z - a <= (one + r) / (w - shift));
}

/// By the depth rule's exact arithmetic alone: of a triangle whose plane double precision does not know.
bool is_admissible_exactly(const View& view, const ViewBounds& bounds, const CornersWorld& p,
                           const PixelCoord& place, float z) {
    TriangleInView triangle(view, bounds, p);
    triangle.is_edge_on = false;
    triangle.own_error = unlimited;
    const TriangleDepth unknown(triangle, bounds);
    EXPECT_FALSE(unknown.certainly_holds(unknown.at(place.x, place.y), z));
    return check_depth(view, bounds, p, unknown, place, z).is_admissible;
}

std::vector<float> depths_around(const DepthBound& bound) {
    std::vector<float> depths;
    for (const double widths : {0.01, 0.99, 1.01, 2.0, 1e3})
        for (const double end :
             {bound.low - widths * (bound.high - bound.low), bound.high + widths * (bound.high - bound.low)})
            if (std::isfinite(float(end)) && end >= 0) depths.push_back(float(end));
    for (const double end : {bound.low, bound.truth, bound.high}) {
        const auto z = float(end);
        constexpr float most = std::numeric_limits<float>::max();
        for (const float depth : {std::nextafter(z, 0.f), z, std::nextafter(z, most)})
            if (std::isfinite(depth) && depth >= 0) depths.push_back(depth);  // others are no answers
    }
    return depths;
}

TEST(TriangleDepth, CertainlyHoldsOnlyWhatIsAdmissibleAndRefusesNoneOfIt) {
    int certain = 0, refused = 0, admissible = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds bounds(s.view, seed % 2 ? Precision(RayPrecision{}) : Precision(RasterPrecision{}));
        for (const Neighbour& n : s.around.neighbours) {
            const TriangleDepth depth(TriangleInView(s.view, bounds, n.p_world), bounds);
            const DepthBound bound = depth.at(s.x, s.y);
            for (const float z : depths_around(bound)) {
                const bool is_admissible = is_admissible_exactly(s.view, bounds, n.p_world, {s.x, s.y}, z);
                const DepthCheck check = check_depth(s.view, bounds, n.p_world, depth, {s.x, s.y}, z);
                ASSERT_EQ(check.is_admissible, is_admissible) << z;
                ASSERT_TRUE(is_admissible || !depth.certainly_holds(bound, z)) << z;
                ASSERT_FALSE(is_admissible && depth.certainly_refuses(bound, z)) << z;
                ++asked, admissible += is_admissible, certain += depth.certainly_holds(bound, z);
                refused += depth.certainly_refuses(bound, z);
            }
        }
    }
    EXPECT_GT(certain, asked / 10);
    EXPECT_GT(refused, asked / 10);
    EXPECT_GT(admissible, certain);
    EXPECT_LT(admissible, 9 * asked / 10);
}

TEST(DepthRule, DecidesAsRationalsDo) {
    int admissible = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 250; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds bounds(s.view, RayPrecision{});
        for (const Neighbour& n : s.around.neighbours) {
            if (!std::isfinite(n.bounds.depth_relative + n.bounds.depth_absolute)) continue;
            const LocalBounds local =
                neighbour_of(ViewRay<double>(s.view, s.x, s.y), bounds, n.p_world).bounds;
            if (!std::isfinite(local.depth_relative + local.depth_absolute)) continue;
            const TriangleDepth depth(TriangleInView(s.view, bounds, n.p_world), bounds);
            for (const float z : depths_around(depth.at(s.x, s.y))) {
                const bool truth = admissible_in_rationals(s, bounds, n.p_world, z);
                ASSERT_EQ(is_admissible_exactly(s.view, bounds, n.p_world, {s.x, s.y}, z), truth) << z;
                ASSERT_EQ(check_depth(s.view, bounds, n.p_world, depth, {s.x, s.y}, z).is_admissible, truth)
                    << z;
                ++asked, admissible += truth;
            }
        }
    }
    EXPECT_GT(admissible, asked / 10);
    EXPECT_LT(admissible, 9 * asked / 10);
}

/// What a run of one pixel says of it.
double certain_error(const TriangleDepth& depth, const PixelCoord& place, float z) {
    const float depths[errors_together] = {z};
    double errors[errors_together]{};
    find_depth_errors(depth, place.x, place.y, 1, depths, errors);
    return errors[0];
}

/// A wall at depth 4 in a view of 4 x 4 pixels, its plane in double as badly known as the test says.
struct Wall {
    Wall(double own_error, Projection projection)
        : view(pixel_view(projection, 4, 4)),
          bounds(view, ray_precision()),
          p_world(corners_of(scene_of(view, {wall(4)}), 0)),
          triangle(view, bounds, p_world) {
        triangle.own_error = own_error;
    }
    TriangleDepth depth() const { return {triangle, bounds}; }

    View view;
    ViewBounds bounds;
    CornersWorld p_world;
    TriangleInView triangle;
};

class OwnError : public testing::TestWithParam<Projection> {};
INSTANTIATE_TEST_SUITE_P(Projections, OwnError,
                         testing::Values(Projection::perspective, Projection::parallel));

TEST_P(OwnError, KeepsADepthNearItsBoundFromBeingCertain) {
    const DepthBound bound = Wall(0, GetParam()).depth().at(1, 1);
    const float inside[] = {std::nextafter(float(bound.low), 4.f), std::nextafter(float(bound.high), 4.f)};
    for (const float z : inside) {
        const Wall known(1e-12, GetParam()), vague(1e-3, GetParam());
        EXPECT_TRUE(known.depth().certainly_holds(bound, z));
        EXPECT_FALSE(vague.depth().certainly_holds(bound, z));
        EXPECT_EQ(certain_error(known.depth(), {1, 1}, z), error_over_bound(bound, z));
        EXPECT_EQ(certain_error(vague.depth(), {1, 1}, z), undecided_error);
    }
}

TEST_P(OwnError, KeepsADepthNearItsBoundFromBeingRefused) {
    const DepthBound bound = Wall(0, GetParam()).depth().at(1, 1);
    const double width = bound.high - bound.low;
    const TriangleDepth known = Wall(1e-12, GetParam()).depth(), vague = Wall(1e-3, GetParam()).depth(),
                        unknown = Wall(1, GetParam()).depth();
    for (const auto& [end, outwards] : {std::pair{bound.low, -width}, std::pair{bound.high, width}}) {
        const auto beside = float(end + 0.5 * outwards), beyond = float(end + 4 * outwards);
        EXPECT_FALSE(known.certainly_refuses(bound, beside));
        EXPECT_TRUE(known.certainly_refuses(bound, beyond));
        EXPECT_FALSE(vague.certainly_refuses(bound, beyond));
        EXPECT_FALSE(unknown.certainly_refuses(bound, beyond));
    }
    EXPECT_TRUE(vague.certainly_refuses(bound, 5));
    EXPECT_EQ(unknown.certainly_refuses(bound, 50), GetParam() == Projection::parallel)
        << "half a plane's inverse depth and more may be error: nothing is beyond it";
    for (const float z : {background_depth, -1.f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_FALSE(known.certainly_refuses(bound, z)) << z;
}

TEST_P(OwnError, LetsExactArithmeticHoldWhatDoubleDoesNot) {
    Wall wall(0, GetParam());
    wall.triangle.inverse_depth.c += 1e-3;
    for (const double own_error : {0.0, 2e-3}) {
        wall.triangle.own_error = own_error;
        const DepthCheck check = check_depth(wall.view, wall.bounds, wall.p_world, wall.depth(), {1, 1}, 4);
        EXPECT_EQ(check.is_admissible, own_error > 0) << "an error that is not known of leaves 4 out";
    }
}

TEST(TriangleDepth, HasNoDepthBeyondTheHorizonOfThePlane) {
    const View view = pixel_view(Projection::perspective, 16, 1);
    const ViewBounds bounds(view, ray_precision());
    // inverse depth falls from 1 at x = 0 to 0 at x = 8
    const Scene scene = scene_of(view, {{{{0, -4, 1}, {4, -4, 2}, {0, 4, 1}}}});
    const TriangleDepth depth(TriangleInView(view, bounds, corners_of(scene, 0)), bounds);
    const DepthBound before = depth.at(6, 0), beyond = depth.at(9, 0);
    EXPECT_NEAR(before.truth, 8 / 1.5, 1e-4);
    EXPECT_LT(before.high, 6);
    for (const double end : {beyond.truth, beyond.high}) EXPECT_TRUE(std::isinf(end) && end > 0);
    for (const float z : {0.f, 1.f, 1e30f}) {
        EXPECT_EQ(certain_error(depth, {9, 0}, z), undecided_error);
        EXPECT_FALSE(depth.certainly_holds(beyond, z));
        EXPECT_FALSE(check_depth(view, bounds, corners_of(scene, 0), depth, {9, 0}, z).is_admissible) << z;
    }
}

TEST(ErrorOverBound, TakesTheBoundOnTheDepthsOwnSide) {
    const DepthBound bound{3, 4, 6};
    EXPECT_EQ(error_over_bound(bound, 4), 0);
    EXPECT_EQ(error_over_bound(bound, 3.5f), 0.5);
    EXPECT_EQ(error_over_bound(bound, 5), 0.5);
    EXPECT_EQ(error_over_bound(bound, 8), 2);
    EXPECT_EQ(error_over_bound(bound, 2), 2);
    EXPECT_EQ(error_over_bound({4, 4, 4}, 4), 0) << "an exact hit needs no bound";
    EXPECT_EQ(error_over_bound({3, unlimited, unlimited}, unlimited), 0);
    EXPECT_EQ(error_over_bound({3, 4, unlimited}, unlimited), 0);
    EXPECT_EQ(error_over_bound(bound, unlimited), unlimited);
}

/// A floor that recedes to a horizon in the middle of the image: above it the floor is seen at no depth.
TEST(TriangleDepth, HoldsNoDepthBeyondAPlanesHorizon) {
    View view = pixel_view(Projection::perspective, 16, 16);
    view.camera.window = {.left = -1, .right = 1, .bottom = -1, .top = 1};
    Scene scene;
    scene.vertices.position_world = {{-64, -1, -2}, {64, -1, -2}, {0, -1, -512}};
    scene.triangles = {{0, 1, 2}};
    for (const Precision& precision : {ray_precision(), raster_precision()}) {
        const ViewBounds bounds(view, precision);
        const TriangleDepth depth(TriangleInView(view, bounds, corners_of(scene, 0)), bounds);
        for (int y = 0; y < 16; ++y) {
            const DepthBound bound = depth.at(8, y);
            EXPECT_FALSE(std::isnan(bound.low) || std::isnan(bound.high)) << "row " << y;
            EXPECT_TRUE(bounds.keeps_to_corners() || (y < 8) == (bound.low == unlimited)) << "row " << y;
        }
    }
}

}  // namespace
}  // namespace zproof
