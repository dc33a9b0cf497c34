#include "compare/truth/depth_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/first_pass/held_depths.h"
#include "compare/truth/admissible.h"
#include "math/rational.h"
#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

/// Lawful by the formula of docs/bounds.md, all in rationals: within the plane's depths over the
/// displacement, and (rasterizers) within the corners' depths, each with its rounding.
bool lawful_in_rationals(const Surroundings& s, const ViewBounds& bounds, const CornersWorld& p,
                         float depth) {
    const Neighbour n = neighbour_of(Sight<double>(s.view, s.x, s.y), bounds, p);
    const auto image = image_of(Sight<Rational>(s.view, s.x, s.y), corners<Rational>(p));
    const Rational z{double(depth)}, r(n.bounds.depth_relative), a(n.bounds.depth_absolute), one(1);
    if (!image) return true;
    const Rational shift(n.bounds.depth_eps_px * n.gradient), w = image->nearness.c;
    if (s.view.camera.projection == Projection::parallel)
        return z + a >= -w - shift - abs(w + shift) * r && z - a <= shift - w + abs(shift - w) * r;
    if (w + shift <= 0) return false;
    return z + a >= (one - r) / (w + shift) && (w - shift <= 0 || z - a <= (one + r) / (w - shift));
}

std::vector<float> depths_around(const DepthBound& bound) {
    std::vector<float> depths;
    for (const double end : {bound.low, bound.truth, bound.high}) {
        const auto z = float(end);
        constexpr float most = std::numeric_limits<float>::max();
        for (const float depth : {std::nextafter(z, 0.f), z, std::nextafter(z, most)})
            if (std::isfinite(depth) && depth >= 0) depths.push_back(depth);  // others are no answers
    }
    return depths;
}

TEST(DepthBound, CertainlyHoldsOnlyWhatIsLawfulAtTheEndsAndTheirNeighbours) {
    int certain = 0, lawful = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds bounds(s.view, seed % 2 ? Precision(RayPrecision{}) : Precision(RasterPrecision{}));
        for (const Neighbour& n : s.around.neighbours) {
            const TriangleDepth depth = depth_of(TriangleInView(s.view, bounds, n.p_world), bounds);
            const DepthBound bound = depth.at(s.x, s.y);
            for (const float z : depths_around(bound)) {
                const bool is_lawful = is_lawful_depth(s.view, bounds, n.p_world, {s.x, s.y}, z);
                ASSERT_TRUE(is_lawful || !depth.certainly_holds(bound, z)) << z;
                ++asked, lawful += is_lawful, certain += depth.certainly_holds(bound, z);
            }
        }
    }
    EXPECT_GT(certain, asked / 10);
    EXPECT_GT(lawful, certain);
    EXPECT_LT(lawful, 9 * asked / 10);
}

/// The ratios of depths at pixels from (x, y) on that all show one triangle, as either renderer's.
struct Place {
    int x, y;
};
std::vector<double> held(const DepthLaw& law, const View& view, const Place& from,
                         std::span<const float> depths) {
    const LawsOfBoth laws{{law_of_nothing, law}, {law_of_nothing, law}};
    const bool perspective = view.camera.projection == Projection::perspective;
    std::vector<double> ratios;
    for (std::size_t first = 0; first < depths.size(); first += Strip::width) {
        const auto here = depths.subspan(first, std::min(Strip::width, depths.size() - first));
        Strip::Values<float> camera_depth{};
        std::ranges::copy(here, camera_depth.begin());
        Strip strip{};
        strip.x = from.x + int(first), strip.y = from.y;
        strip.candidate.camera_depth = camera_depth.data();
        strip.reference = strip.candidate;
        LawsAlong along{};
        std::fill_n(along.candidate.begin(), here.size(), 1);
        along.reference = along.candidate;
        SortedStrip all;
        (perspective ? hold_perspective : hold_parallel)(laws, strip, along, all);
        EXPECT_EQ(all.ratio.candidate, all.ratio.reference);
        ratios.insert(ratios.end(), all.ratio.candidate.begin(),
                      all.ratio.candidate.begin() + std::ptrdiff_t(here.size()));
    }
    return ratios;
}

TEST(DepthBound, OfARowHasTheBitsOfEveryPixelsOwn) {
    int settled = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds bounds(s.view, seed % 2 ? Precision(RayPrecision{}) : Precision(RasterPrecision{}));
        for (const Neighbour& n : s.around.neighbours) {
            const TriangleInView triangle(s.view, bounds, n.p_world);
            const TriangleDepth depth = depth_of(triangle, bounds);
            std::vector<float> z;
            for (int x = 0; x < s.view.width; ++x) {
                const auto around = depths_around(depth.at(x, s.y));
                z.push_back(around.empty() ? 1 : around[std::size_t(x) % around.size()]);
            }
            const std::vector<double> ratio = held(depth_law_of(triangle, bounds), s.view, {0, s.y}, z);
            for (std::size_t x = 0; x < z.size(); ++x) {
                ++asked;
                if (ratio[x] == unsettled) continue;
                const DepthBound bound = depth.at(int(x), s.y);
                ASSERT_TRUE(depth.certainly_holds(bound, z[x])) << x;
                ASSERT_EQ(ratio[x], error_over_bound(bound, z[x])) << x;
                ++settled;
            }
        }
    }
    EXPECT_GT(settled, asked / 10);
    EXPECT_LT(settled, 9 * asked / 10);
}

/// The laws of all neighbours in turn, pixel by pixel and in runs; the reference now and then shows another
/// triangle than the candidate does.
TEST(DepthBound, OfNeighboursIsEachOnesOwnInOneStrip) {
    int settled = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds raster(s.view, RasterPrecision{}), ray(s.view, RayPrecision{});
        LawsOfBoth laws{{law_of_nothing}, {law_of_nothing}};
        for (const Neighbour& n : s.around.neighbours) {
            const TriangleInView triangle(s.view, raster, n.p_world);
            laws.candidate.push_back(depth_law_of(triangle, raster));
            laws.reference.push_back(depth_law_of(triangle, ray));
        }
        const bool perspective = s.view.camera.projection == Projection::perspective;
        const auto hold = perspective ? hold_perspective : hold_parallel;
        Strip mixed{};
        mixed.x = 3, mixed.y = s.y;
        LawsAlong along{};
        for (std::size_t i = 0; i < Strip::width; ++i) {
            const std::size_t shown = i < 24 ? i : i / 11;
            along.candidate[i] = std::uint32_t(shown % laws.candidate.size());
            along.reference[i] = std::uint32_t((shown + (i % 7 == 0)) % laws.candidate.size());
        }
        Strip::Values<float> camera_depth;
        camera_depth.fill(s.around.neighbours.empty() ? 1 : float(s.around.neighbours[0].nearest));
        mixed.candidate.camera_depth = mixed.reference.camera_depth = camera_depth.data();
        SortedStrip together;
        hold(laws, mixed, along, together);
        for (std::uint32_t which = 0; which < laws.candidate.size(); ++which) {
            LawsAlong alone;
            alone.candidate.fill(which);
            alone.reference.fill(which);
            SortedStrip by_itself;
            hold(laws, mixed, alone, by_itself);
            const auto expect_same = [&](const auto& law, const Strip::Values<double>& here,
                                         const Strip::Values<double>& there) {
                for (std::size_t i = 0; i < Strip::width; ++i) {
                    if (law[i] != which) continue;
                    EXPECT_EQ(here[i], there[i]) << i;
                    settled += here[i] != unsettled;
                }
            };
            expect_same(along.candidate, together.ratio.candidate, by_itself.ratio.candidate);
            expect_same(along.reference, together.ratio.reference, by_itself.ratio.reference);
        }
    }
    EXPECT_GT(settled, 2000);
}

TEST(DepthBound, IsDecidedAsRationalsDecide) {
    int lawful = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 250; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds bounds(s.view, RayPrecision{});
        for (const Neighbour& n : s.around.neighbours) {
            if (!std::isfinite(n.bounds.depth_relative + n.bounds.depth_absolute)) continue;
            const LocalBounds local = neighbour_of(Sight<double>(s.view, s.x, s.y), bounds, n.p_world).bounds;
            if (!std::isfinite(local.depth_relative + local.depth_absolute)) continue;
            for (const float z :
                 depths_around(depth_of(TriangleInView(s.view, bounds, n.p_world), bounds).at(s.x, s.y))) {
                const bool truth = lawful_in_rationals(s, bounds, n.p_world, z);
                ASSERT_EQ(is_lawful_depth(s.view, bounds, n.p_world, {s.x, s.y}, z), truth) << z;
                ++asked, lawful += truth;
            }
        }
    }
    EXPECT_GT(lawful, asked / 10);
    EXPECT_LT(lawful, 9 * asked / 10);
}

/// A wall at depth 4 in a view of 4 x 4 pixels, its plane in double as badly known as the test says.
struct Wall {
    Wall(double own_error, Projection projection)
        : view(pixel_view(projection, 4, 4)),
          bounds(view, ray_precision()),
          triangle(view, bounds, corners_of(scene_of(view, {wall(4)}), 0)) {
        triangle.nearness.own_error = own_error;
    }
    TriangleDepth depth() const { return depth_of(triangle, bounds); }
    double ratio_at_1_1(float z) const {
        return held(depth_law_of(triangle, bounds), view, {1, 1}, std::span(&z, 1))[0];
    }

    View view;
    ViewBounds bounds;
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
        EXPECT_EQ(known.ratio_at_1_1(z), error_over_bound(bound, z));
        EXPECT_EQ(vague.ratio_at_1_1(z), unsettled);
    }
}

TEST(DepthBound, HasNoDepthBeyondTheHorizonOfThePlane) {
    const View view = pixel_view(Projection::perspective, 16, 1);
    const ViewBounds bounds(view, ray_precision());
    // nearness falls from 1 at x = 0 to 0 at x = 8
    const Scene scene = scene_of(view, {{{{0, -4, 1}, {4, -4, 2}, {0, 4, 1}}}});
    const TriangleInView triangle(view, bounds, corners_of(scene, 0));
    const TriangleDepth depth = depth_of(triangle, bounds);
    const DepthBound before = depth.at(6, 0), beyond = depth.at(9, 0);
    EXPECT_NEAR(before.truth, 8 / 1.5, 1e-4);
    EXPECT_LT(before.high, 6);
    for (const double end : {beyond.truth, beyond.high}) EXPECT_TRUE(std::isinf(end) && end > 0);
    for (const float z : {0.f, 1.f, 1e30f}) {
        EXPECT_EQ(held(depth_law_of(triangle, bounds), view, {9, 0}, std::span(&z, 1))[0], unsettled);
        EXPECT_FALSE(depth.certainly_holds(beyond, z));
        EXPECT_FALSE(is_lawful_depth(view, bounds, corners_of(scene, 0), {9, 0}, z)) << z;
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
}

/// A floor that recedes to a horizon in the middle of the image: above it the floor is seen at no depth.
TEST(DepthBound, HoldsNoDepthBeyondAPlanesHorizon) {
    View view = pixel_view(Projection::perspective, 16, 16);
    view.camera.window = {.left = -1, .right = 1, .bottom = -1, .top = 1};
    Scene scene;
    scene.vertices.position_world = {{-64, -1, -2}, {64, -1, -2}, {0, -1, -512}};
    scene.triangles = {{0, 1, 2}};
    for (const Precision& precision : {ray_precision(), raster_precision()}) {
        const ViewBounds bounds(view, precision);
        const TriangleDepth depth = depth_of(TriangleInView(view, bounds, corners_of(scene, 0)), bounds);
        for (int y = 0; y < 16; ++y) {
            const DepthBound bound = depth.at(8, y);
            EXPECT_FALSE(std::isnan(bound.low) || std::isnan(bound.high)) << "row " << y;
            EXPECT_TRUE(bounds.keeps_to_corners() || (y < 8) == (bound.low == unlimited)) << "row " << y;
        }
    }
}

}  // namespace
}  // namespace zproof
