#include "measure/measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "measure/instruments.h"
#include "subjects.h"

namespace zproof::measure {
namespace {

struct Grid {
    int bits;
    Snap snap;
};

class EveryGrid : public testing::TestWithParam<Grid> {};

TEST_P(EveryGrid, IsMeasuredAsItIs) {
    const auto [bits, snap] = GetParam();
    for (const Axis axis : both_axes) {
        const Displacement found =
            displacement(by_rules({.subpixel_bits = bits, .snap = snap}), Sample{}, axis);
        ASSERT_TRUE(found.grid);
        EXPECT_LE(found.grid->step_px.low, std::exp2(-bits));
        EXPECT_GE(found.grid->step_px.high, std::exp2(-bits));
        EXPECT_LT(found.grid->step_px.high - found.grid->step_px.low, std::exp2(-bits) / 100);
        EXPECT_EQ(found.grid->snap,
                  snap == Snap::nearest ? SnapRounding::nearest : SnapRounding::towards_smaller);
        if (snap == Snap::nearest) {
            EXPECT_EQ(found.grid->ties, TieRounding::to_even);
        }
    }
}

TEST_P(EveryGrid, MovesVerticesByNoMoreThanItsStepAllows) {
    const auto [bits, snap] = GetParam();
    const double step = std::exp2(-bits);
    for (const Axis axis : both_axes) {
        const Bracket seen =
            displacement(by_rules({.subpixel_bits = bits, .snap = snap}), Sample{}, axis).at_least_px;
        const Bracket allowed = snap == Snap::nearest ? Bracket{-step / 2, step / 2} : Bracket{-step, 0};
        EXPECT_GE(seen.low, allowed.low);
        EXPECT_LE(seen.high, allowed.high);
        EXPECT_GT(seen.high - seen.low, 0.8 * step);  // 49 thresholds see nearly all of it
    }
}

INSTANTIATE_TEST_SUITE_P(Grids, EveryGrid,
                         testing::Values(Grid{4, Snap::nearest}, Grid{6, Snap::nearest},
                                         Grid{8, Snap::nearest}, Grid{10, Snap::nearest},
                                         Grid{12, Snap::nearest}, Grid{4, Snap::truncate},
                                         Grid{8, Snap::truncate}, Grid{12, Snap::truncate}),
                         [](const auto& grid) {
                             return std::to_string(grid.param.bits) + "Bits" +
                                    (grid.param.snap == Snap::nearest ? "Nearest" : "Truncated");
                         });

TEST(SubpixelGrid, TiesThatAllGoOneWayAreTold) {
    const auto rounded = [](float x) { return std::floor(x * 16 + 0.5f) / 16; };
    const Renderer right_and_up = with_moved_vertices([=](glm::vec3 p, auto) {
        return glm::vec3{rounded(p.x), rounded(p.y), p.z};
    });
    const Displacement x = displacement(right_and_up, Sample{}, Axis::x);
    const Displacement y = displacement(right_and_up, Sample{}, Axis::y);
    ASSERT_TRUE(x.grid && y.grid);
    EXPECT_LE(x.grid->step_px.low, 1.0 / 16);
    EXPECT_GE(x.grid->step_px.high, 1.0 / 16);
    EXPECT_EQ(x.grid->ties, TieRounding::towards_greater);
    EXPECT_EQ(y.grid->ties, TieRounding::towards_smaller);
}

TEST(SubpixelGrid, SnapToTheGreaterLineIsTold) {
    const auto up = [](float x) { return std::ceil(x * 16) / 16; };
    const Renderer renderer = with_moved_vertices([=](glm::vec3 p, auto) {
        return glm::vec3{up(p.x), p.y, p.z};
    });
    const Displacement x = displacement(renderer, Sample{}, Axis::x);
    ASSERT_TRUE(x.grid);
    EXPECT_EQ(x.grid->snap, SnapRounding::towards_greater);
    EXPECT_GT(x.at_least_px.high, 0.9 / 16);
    EXPECT_LE(x.at_least_px.high, 1.0 / 16);
}

// A ray caster in miniature: one edge function in doubles per pixel, no grid at all.
Frame without_a_grid(const Scene& scene, const View& view) {
    Frame frame({view.width, view.height});
    const auto& positions = scene.vertices.position_world;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
        std::array<glm::dvec2, 3> p;
        for (int k = 0; k < 3; ++k) {
            const glm::vec3& v = positions[scene.triangles[t][k]];
            p[std::size_t(k)] = {v.x, -v.y};
        }
        const auto side = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
            return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        };
        for (int y = 0; y < view.height; ++y) {
            for (int x = 0; x < view.width; ++x) {
                const glm::dvec2 c{x + 0.5, y + 0.5};
                const double a = side(p[0], p[1], c), b = side(p[1], p[2], c), d = side(p[2], p[0], c);
                if ((a > 0 && b > 0 && d > 0) || (a < 0 && b < 0 && d < 0))
                    frame.primitive.at(x, y) = PrimitiveId{t};
            }
        }
    }
    return frame;
}

TEST(SubpixelGrid, NoneIsFoundWhereThereIsNone) {
    const Renderer caster{.name = "caster", .render = without_a_grid, .declared = RayPrecision{}};
    for (const Axis axis : both_axes) {
        const Displacement found = displacement(caster, Sample{}, axis);
        EXPECT_FALSE(found.grid);
        EXPECT_LE(found.finest_px, 0x1p-14);
        EXPECT_LE(found.at_least_px.high - found.at_least_px.low, 0x1p-16);
    }
}

TEST(PixelCentre, IsFoundWhereverItIs) {
    for (const double offset : {0.0, 0.25, 0.5, 0.75}) {
        for (const Bracket& centre : pixel_centre(by_rules({.sample_offset_px = offset}))) {
            EXPECT_LE(centre.low, offset);
            EXPECT_GE(centre.high, offset);
            EXPECT_LT(centre.high - centre.low, 1.0 / 2046);  // 1/2047, rounded
        }
    }
}

TEST(FillSide, OfTheCorrectRasterizerIsTopLeft) {
    for (const FillSide& side : fill_sides(by_rules({}), Sample{}))
        EXPECT_EQ(side.owns, side.dy < 0 || (side.dy == 0 && side.dx > 0)) << side.dx << " " << side.dy;
    const auto all = findings(measure(by_rules({})), rasterizer::precision());
    EXPECT_EQ(finding(all, "fill_side").words, "top, left");
}

TEST(FillSide, FollowsAShiftedSample) {
    for (const FillSide& side : fill_sides(by_rules({.sample_offset_px = 0.25}), Sample{0.25, 0.25}))
        EXPECT_EQ(side.owns, side.dy < 0 || (side.dy == 0 && side.dx > 0)) << side.dx << " " << side.dy;
}

TEST(DepthSteps, OfAFloat32BufferAreItsUlps) {
    for (const DepthStep& found : depth_steps(by_rules({}))) {
        if (found.projection != Projection::parallel) continue;
        const double ulp = std::exp2(std::floor(std::log2(found.depth)) - 23);
        EXPECT_LE(found.step.low, ulp) << found.depth;
        EXPECT_GE(found.step.high, ulp) << found.depth;
        EXPECT_LT(found.step.high - found.step.low, ulp * 1e-3) << found.depth;
        EXPECT_LE(found.error, ulp) << found.depth;
    }
}

// The buffer holds 1 / depth: a step of it is a step of depth^2 in depth.
TEST(DepthSteps, InPerspectiveAreThoseOfTheReciprocal) {
    for (const DepthStep& found : depth_steps(by_rules({}))) {
        if (found.projection != Projection::perspective) continue;
        const double ulp = std::exp2(std::floor(std::log2(1 / found.depth)) - 23);
        const double step = ulp * found.depth * found.depth;
        EXPECT_NEAR(found.step.middle() / step, 1, 1e-3) << found.depth;
    }
}

TEST(DepthSteps, OfACoarseBufferAreFound) {
    constexpr double coarse = 0x1p-7;  // 16 bits over 512 units
    const Renderer renderer = with_moved_vertices([](glm::vec3 p, glm::vec3 eye) {
        const double depth = std::round((double(eye.z) - p.z) / coarse) * coarse;
        return glm::vec3{p.x, p.y, float(eye.z - depth)};
    });
    for (const DepthStep& found : depth_steps(renderer)) {
        EXPECT_LE(found.step.low, coarse);
        EXPECT_GE(found.step.high, coarse);
        EXPECT_GT(found.error, 0.49 * coarse);
    }
}

TEST(DepthLimits, CutAtThePlanesAndKeepThem) {
    for (const DepthLimit& limit : depth_limits(by_rules({}))) {
        ASSERT_TRUE(limit.offset);
        EXPECT_TRUE(limit.keeps_plane);
        EXPECT_LE(std::abs(limit.offset->middle()), 0x1p-53 * limit.depth);
    }
}

TEST(Watertightness, CountsEveryPixelOfBothMeshes) {
    const Watertightness found = watertightness(by_rules({}), Sample{});
    EXPECT_EQ(found.pixels, 2u * 128 * 128);
    EXPECT_EQ(found.holes, 0u);
    EXPECT_EQ(found.double_hits, 0u);
}

TEST(Findings, OfTheCorrectRasterizerAreAsDeclared) {
    const auto all = findings(measure(by_rules({})), rasterizer::precision());
    EXPECT_FALSE(is_worse(all)) << worse_in(all).front();
    const Bracket bits = finding(all, "subpixel_bits_x").value.value();
    EXPECT_LE(bits.low, 8);
    EXPECT_GE(bits.high, 8);
    EXPECT_EQ(finding(all, "snap_y").words, "nearest, ties to even");
    for (const Finding& f : all) EXPECT_EQ(f.conformity, Conformity::as_declared) << f.name;
}

TEST(Findings, BetterThanDeclaredIsNotWorse) {
    EXPECT_FALSE(is_worse(findings(measure(by_rules({.subpixel_bits = 10})), rasterizer::precision())));
}

TEST(Findings, PromiseOfAFinerGridIsNotKept) {
    const auto all = findings(measure(by_rules({})), RasterPrecision{.subpixel_bits = 9});
    EXPECT_EQ(finding(all, "subpixel_bits_x").conformity, Conformity::worse);
}

/// A closed test meets both triangles of a shared edge. Integer edge functions promise a fill rule; rounded
/// ones, rays and who knows nothing of its arithmetic do not.
TEST(Findings, OnlyWhoPromisesAFillRuleIsHeldToSingleOwners) {
    const Measurement closed = measure(by_rules({.fill = rasterizer::FillRule::inclusive}));
    const std::vector<Precision> without_a_rule{
        RayPrecision{},
        PlaneRayPrecision{},
        BoundedPrecision{.eps_px = 0.01, .depth_relative = 1e-6},
        RasterPrecision{.edge_functions = EdgeFunctions::from_corner},
        RasterPrecision{.edge_functions = EdgeFunctions::window_coefficients},
        RasterPrecision{.barycentric_tolerance = 1e-6}};
    for (const Precision& precision : without_a_rule) {
        const auto all = findings(closed, precision);
        EXPECT_FALSE(is_worse(all)) << worse_in(all).front();
        EXPECT_EQ(finding(all, "fill_side").conformity, Conformity::undeclared);
        EXPECT_EQ(finding(all, "double_hits").conformity, Conformity::undeclared);
        EXPECT_GT(finding(all, "double_hits").value.value().low, 0) << "the figure stays";
    }
    EXPECT_EQ(worse_in(findings(closed, RasterPrecision{})),
              (std::vector<std::string>{"fill_side", "double_hits"}));
}

TEST(Findings, AClosedTestThatPromisesWatertightnessIsHeldToIt) {
    const auto all = findings(measure(by_rules({.fill = rasterizer::FillRule::exclusive})), RayPrecision{});
    EXPECT_EQ(worse_in(all), std::vector<std::string>{"holes"});
}

TEST(Findings, ARayCasterIsNotHeldToAGrid) {
    for (const Finding& f : findings(measure(by_rules({})), RayPrecision{}))
        EXPECT_NE(f.conformity, Conformity::worse) << f.name;
}

}  // namespace
}  // namespace zproof::measure
