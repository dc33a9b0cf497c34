/// The rule of interpolated values from both sides: a renderer at the end of its promise passes, one
/// hundredth beyond it fails.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "compare/attributes/attribute_check.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr std::size_t bary_u = 0, uv_u = 2, uv_v = 3, normal_x = 4, position_x = 7;
constexpr std::array projections{Projection::perspective, Projection::parallel};

/// Snaps by up to a step of 1/16 px.
const Precision coarse = RasterPrecision{.transform = Arithmetic::float64,
                                         .subpixel_bits = 4,
                                         .snap = Snap::truncate,
                                         .interpolation = Arithmetic::float64,
                                         .depth_roundings = 1};
constexpr double step = 1.0 / 16;

/// One triangle and a frame of one pixel that shows it, sampled at (0.5, 0.5).
struct OnePixel {
    TestScene t;
    Precision precision;

    OnePixel(Projection projection, const Triangle& triangle, const Precision& p)
        : t(projection, 1, 1, {triangle}), precision(p) {
        answer(t.candidate, 0, 0, 0, triangle[0].depth);
        t.scene.vertices.uv.push_back({glm::vec2(0.25, -1), glm::vec2(0.5, 1), glm::vec2(0.375, 3)});
        t.scene.vertices.normal_world = {glm::vec3(0, 0, 1), glm::vec3(0, 0.5, 1), glm::vec3(0.5, 0, 1)};
    }
    /// Is this frame wrong, which gives nothing else?
    std::optional<WrongAttribute> wrong(std::size_t channel, std::initializer_list<double> values) {
        t.candidate.attributes = {};
        for (const double value : values)
            t.candidate.attributes.planes[channel++] = Plane<float>({1, 1}, float(value));
        return AttributeCheck(t.scene, t.view, t.candidate, precision).at({0, 0}).wrong;
    }
    bool is_wrong(std::size_t channel, std::initializer_list<double> values) {
        return wrong(channel, values).has_value();
    }
};

/// Perspective-correct shares of the corners at (0.5, 0.5); nothing where that lies outside.
std::optional<std::array<double, 3>> shares_at_centre(Projection projection, const Triangle& t) {
    const auto area = [](const Corner& a, const Corner& b) {
        return (a.x - 0.5) * (b.y - 0.5) - (a.y - 0.5) * (b.x - 0.5);
    };
    std::array<double, 3> shares{area(t[1], t[2]), area(t[2], t[0]), area(t[0], t[1])};
    const double whole = shares[0] + shares[1] + shares[2];
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (whole == 0 || shares[i] / whole < 0) return std::nullopt;
        shares[i] /= whole * (projection == Projection::perspective ? t[i].depth : 1);
        sum += shares[i];
    }
    for (double& share : shares) share /= sum;
    return shares;
}

/// Every corner moved to a corner of its square, or left where it is: the centre's values are right, and
/// garbage is wrong, down to triangles that are thinner than a step.
TEST(SmallTriangles, GiveWhatTheirMovedCornersGiveAndNothingElse) {
    std::mt19937 random(7);
    int tried = 0;
    for (int n = 0; n < 4000; ++n) {
        const Projection projection = projections[std::size_t(n) % 2];
        const double size = std::ldexp(1.0, -int(random() % 6));
        Triangle triangle, moved;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto near_centre = [&] { return 0.5 + size * (double(random() % 2048) / 1024 - 1); };
            triangle[i] = {near_centre(), near_centre(), std::ldexp(1.0, int(random() % 3))};
            moved[i] = triangle[i];
            moved[i].x += (int(random() % 3) - 1) * step;
            moved[i].y += (int(random() % 3) - 1) * step;
        }
        const auto m = shares_at_centre(projection, moved);
        if (!m) continue;
        SCOPED_TRACE(n);
        ++tried;
        for (const Precision& precision : {coarse, Precision(BoundedPrecision{.eps_px = step})}) {
            OnePixel pixel(projection, triangle, precision);
            const auto& p = pixel.t.scene.vertices.position_world;
            const auto mean = [&](double a, double b, double c) {
                return (*m)[0] * a + (*m)[1] * b + (*m)[2] * c;
            };
            EXPECT_FALSE(pixel.is_wrong(bary_u, {(*m)[1], (*m)[2]}));
            EXPECT_FALSE(pixel.is_wrong(uv_u, {mean(0.25, 0.5, 0.375), mean(-1, 1, 3)}));
            EXPECT_FALSE(pixel.is_wrong(normal_x, {7 * mean(0, 0, 0.5), 7 * mean(0, 0.5, 0), 7}));
            EXPECT_FALSE(pixel.is_wrong(
                position_x,
                {mean(p[0].x, p[1].x, p[2].x), mean(p[0].y, p[1].y, p[2].y), mean(p[0].z, p[1].z, p[2].z)}));
            EXPECT_TRUE(pixel.is_wrong(uv_u, {1e30, 0}));
            EXPECT_TRUE(pixel.is_wrong(bary_u, {-7, 0}));
            EXPECT_TRUE(pixel.is_wrong(normal_x, {0, 0, -1}));
            EXPECT_TRUE(pixel.is_wrong(position_x, {1e20, 0, 0}));
        }
    }
    EXPECT_GT(tried, 500);
}

/// A mesh of triangles of 0.13 px, with what is no texture coordinate of any of them.
TEST(SmallTriangles, OfAMeshWithAnyValueAreWrongAtEveryPixel) {
    constexpr int cells = 62, side = 8;
    std::vector<Triangle> mesh;
    for (int i = 0; i < cells * cells; ++i) {
        const double x = 0.13 * (i % cells), y = 0.13 * (i / cells), end = 0.13;
        mesh.push_back({{{x, y, 4}, {x + end, y, 4}, {x, y + end, 4}}});
        mesh.push_back({{{x + end, y, 4}, {x + end, y + end, 4}, {x, y + end, 4}}});
    }
    for (const Projection projection : projections) {
        TestScene t(projection, side, side, mesh);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double in_cells_x = (x + 0.5) / 0.13, in_cells_y = (y + 0.5) / 0.13;
                const int i = int(in_cells_x), j = int(in_cells_y);
                const bool is_second = in_cells_x - i + in_cells_y - j > 1;
                for (Frame* frame : {&t.candidate, &t.reference})
                    answer(*frame, x, y, std::uint32_t(2 * (cells * j + i) + is_second), 4);
            }
        for (const Precision& precision :
             {coarse, Precision(BoundedPrecision{.eps_px = 0.07, .depth_relative = 1e-6})}) {
            t.candidate_precision = precision;
            t.candidate.attributes = {};
            EXPECT_EQ(t.verdict().counts[std::size_t(PixelClass::agree)], 64u);
            t.scene.vertices.uv.resize(1);
            t.scene.vertices.uv[0].assign(t.scene.vertices.position_world.size(), glm::vec2(0.5));
            for (const std::size_t channel : {uv_u, uv_v})
                t.candidate.attributes.planes[channel] = Plane<float>({side, side}, 0.5f);
            EXPECT_EQ(t.verdict().counts[std::size_t(PixelClass::agree)], 64u);
            for (const float garbage : {1e30f, 7.0f, 0.50001f}) {
                t.candidate.attributes.planes[uv_v] = Plane<float>({side, side}, garbage);
                EXPECT_EQ(t.verdict().counts[std::size_t(PixelClass::wrong_attribute)], 64u) << garbage;
            }
        }
    }
}

/// A triangle whose plane holds the eye, and one without area: a mean of the corners, whatever the place.
TEST(EdgeOnTriangles, GiveMeansOfTheirCorners) {
    const Triangle upright{{{0.5, 0.25, 2}, {0.5, 0.75, 4}, {0.5, 0.75, 8}}},
        flat{{{0.25, 0.5, 4}, {0.5, 0.5, 4}, {0.75, 0.5, 4}}};
    for (const Projection projection : projections)
        for (const Triangle& triangle : {upright, flat})
            for (const Precision& precision :
                 {coarse, raster_precision(), ray_precision(), Precision(BoundedPrecision{.eps_px = step}),
                  Precision(RasterPrecision{.edge_functions = EdgeFunctions::from_corner})}) {
                if (projection == Projection::parallel &&
                    std::holds_alternative<RasterPrecision>(precision) &&
                    std::get<RasterPrecision>(precision).edge_functions != EdgeFunctions::exact)
                    continue;
                OnePixel pixel(projection, triangle, precision);
                EXPECT_FALSE(pixel.is_wrong(uv_u, {0.25, -1}));
                EXPECT_FALSE(pixel.is_wrong(uv_u, {0.5, 3}));
                EXPECT_TRUE(pixel.is_wrong(uv_u, {0.2475, 0}));
                EXPECT_TRUE(pixel.is_wrong(uv_u, {0.5025, 0}));
                EXPECT_TRUE(pixel.is_wrong(uv_u, {0.25, 3.04}));
                EXPECT_FALSE(pixel.is_wrong(bary_u, {0.5, 0.5}));
                EXPECT_TRUE(pixel.is_wrong(bary_u, {1.01, 0}));
                EXPECT_TRUE(pixel.is_wrong(bary_u, {-0.01, 0}));
                EXPECT_TRUE(pixel.is_wrong(normal_x, {0, 0, -1}));
            }
}

/// The centre lies outside by 3/64 px. A value is one of the triangle, or that of its plane at the centre,
/// but none between.
TEST(TheCentreBeside, IsAdmissibleByItself) {
    const double x = 0.5 + 3.0 / 64;
    for (const Projection projection : projections) {
        OnePixel pixel(projection, {{{x, 0, 4}, {x + 0.25, 0.5, 4}, {x, 1, 4}}}, coarse);
        const double at_centre = -3.0 / 16, farthest = 1.0 / 16;
        EXPECT_FALSE(pixel.is_wrong(bary_u, {0, 0.5}));
        EXPECT_FALSE(pixel.is_wrong(bary_u, {at_centre, 0.5 - at_centre / 2}));
        EXPECT_TRUE(pixel.is_wrong(bary_u, {1.01 * at_centre, 0.5 - at_centre / 2}));
        EXPECT_TRUE(pixel.is_wrong(bary_u, {0.99 * at_centre, 0.5 - at_centre / 2}));
        EXPECT_TRUE(pixel.is_wrong(bary_u, {-0.01, 0.5}));
        EXPECT_FALSE(pixel.is_wrong(bary_u, {0.99 * farthest, 0.5}));
        EXPECT_TRUE(pixel.is_wrong(bary_u, {1.01 * farthest, 0.5}));
        const auto told = pixel.wrong(bary_u, {-0.1, 0.5});
        ASSERT_TRUE(told);
        EXPECT_GT(told->error_over_bound, 1);
    }
}

/// Of weights that may be below 0 by a tolerance, all three count: the corners' values span 0 to 1.
TEST(Tolerances, WidenTheRangeOfMeans) {
    constexpr double tolerance = 1.0 / 64;
    const Precision homogeneous =
        RasterPrecision{.edge_functions = EdgeFunctions::homogeneous, .barycentric_tolerance = tolerance};
    const Precision ray = RayPrecision{.test = RayTest::moeller_trumbore, .barycentric_tolerance = tolerance};
    // seen in a square of no more than rounding: what limits values here are the corners
    for (const Precision& precision : {homogeneous, ray}) {
        OnePixel pixel(Projection::perspective, {{{0.5, 0.5, 4}, {0.5, 0.5, 4}, {0.5, 0.5, 4}}}, precision);
        EXPECT_FALSE(pixel.is_wrong(bary_u, {-3 * tolerance, 0}));
        EXPECT_FALSE(pixel.is_wrong(bary_u, {1 + 3 * tolerance, 0}));
        EXPECT_TRUE(pixel.is_wrong(bary_u, {-3.03 * tolerance, 0}));
        EXPECT_TRUE(pixel.is_wrong(bary_u, {1 + 3.03 * tolerance, 0}));
    }
}

/// A small area that an epsilon is added to makes values smaller, down to 0, and no larger.
TEST(AnAreasEpsilon, MayMakeValuesSmaller) {
    OnePixel pixel(Projection::perspective, {{{0.49, 0.49, 4}, {0.51, 0.49, 4}, {0.49, 0.51, 4}}},
                   RasterPrecision{.subpixel_bits = 4, .area_epsilon_px2 = 1});
    EXPECT_FALSE(pixel.is_wrong(uv_u, {0.001, 0.001}));
    EXPECT_FALSE(pixel.is_wrong(uv_u, {0.4, 0.5}));
    EXPECT_TRUE(pixel.is_wrong(uv_u, {0.51, 0.5}));
    EXPECT_TRUE(pixel.is_wrong(uv_u, {-0.001, 0.5}));
    EXPECT_TRUE(pixel.is_wrong(uv_u, {1e30, 0.5}));
}

/// `rcpps` is off by a share of 1.5 2^-12, as many roundings as 6144; both sums of a value may be divided so.
TEST(ApproximateReciprocals, CountAsRoundings) {
    constexpr double error = 1.5 / 4096;
    RasterPrecision promise{.interpolation = Arithmetic::float64, .depth_roundings = 6144};
    OnePixel pixel(Projection::perspective, wall(4), promise);
    pixel.t.scene.vertices.uv = {{glm::vec2(1), glm::vec2(1), glm::vec2(1)}};
    for (const double value : {1 + error, 1 - error, 1 + 1.99 * error, 1 - 1.99 * error})
        EXPECT_FALSE(pixel.is_wrong(uv_u, {value, 1})) << value;
    for (const double value : {1 + 2.02 * error, 1 - 2.02 * error})
        EXPECT_TRUE(pixel.is_wrong(uv_u, {value, 1})) << value;
    promise.depth_roundings = 2;
    pixel.precision = promise;
    EXPECT_TRUE(pixel.is_wrong(uv_u, {1 + error / 100, 1}));
}

TEST(ADepthThatMayBeAnything, PromisesNoAttributes) {
    OnePixel pixel(Projection::perspective, wall(4), BoundedPrecision{.eps_px = step, .depth_relative = 1});
    EXPECT_FALSE(pixel.is_wrong(uv_u, {1e30, 0}));
    EXPECT_EQ(unjudged_attributes(pixel.t.scene, pixel.t.view, pixel.t.candidate.attributes, pixel.precision)
                  .size(),
              1u);
    pixel.precision = BoundedPrecision{.eps_px = step, .depth_relative = 0.99};
    EXPECT_TRUE(pixel.is_wrong(uv_u, {1e30, 0}));
}

/// A wall at depth 4 whose promise is `step` across and a thousandth of the depth along. It may be seen at
/// the corner of the square, and at the end of its depth; float32 takes 1e-6 of both.
class Positions : public testing::TestWithParam<Projection> {
  protected:
    OnePixel pixel{GetParam(), wall(4), BoundedPrecision{.eps_px = step, .depth_relative = 1e-3}};

    /// Of the point that is seen at (0.5 + x, 0.5 + y) at this depth.
    bool is_wrong(double x, double y, double depth) {
        const double scale = GetParam() == Projection::perspective ? depth : 1;
        return pixel.is_wrong(position_x, {(0.5 + x) * scale, -(0.5 + y) * scale, -depth});
    }
};
INSTANTIATE_TEST_SUITE_P(Projections, Positions, testing::ValuesIn(projections), [](const auto& projection) {
    return projection.param == Projection::perspective ? "Perspective" : "Parallel";
});

TEST_P(Positions, AreHeldAcrossTheRay) {
    // interpolated coordinates err by 2.2e-3 of the largest, 64 px and more, so that all is measured from
    // there
    pixel.precision = BoundedPrecision{.eps_px = step};
    constexpr double inside = step + 2e-6, outside = 1.01 * step + 1e-4;
    for (const double x : {-1, 0, 1})
        for (const double y : {-1, 0, 1}) {
            EXPECT_FALSE(is_wrong(x * step, y * step, 4)) << x << ' ' << y;
            EXPECT_EQ(is_wrong(x * outside, y * inside, 4), x != 0) << x << ' ' << y;
            EXPECT_EQ(is_wrong(x * inside, y * outside, 4), y != 0) << x << ' ' << y;
        }
}

/// Made from the depth that is shown: 1e-3 of it. Interpolated: twice that, of both sums.
TEST_P(Positions, AreHeldAlongTheRay) {
    for (const double side : {-1.0, 1.0}) {
        EXPECT_FALSE(is_wrong(0, 0, 4 * (1 + side * 1e-3)));
        EXPECT_FALSE(is_wrong(0, 0, 4 * (1 + side * 2e-3)));
        EXPECT_TRUE(is_wrong(0, 0, 4 * (1 + side * 2.03e-3)));
    }
    pixel.precision = BoundedPrecision{.eps_px = step, .depth_absolute = 1e-3};
    const double limit = GetParam() == Projection::perspective ? 2e-3 : 1e-3;
    for (const double side : {-1.0, 1.0}) {
        EXPECT_FALSE(is_wrong(0, 0, 4 + side * limit));
        EXPECT_TRUE(is_wrong(0, 0, 4 + side * 1.02 * limit));
    }
}

/// Off its ray a position is wrong even where no coordinate by itself is: a plane that runs into the depth
/// has many.
TEST_P(Positions, AreNotHeldOneCoordinateAtATime) {
    OnePixel steep(GetParam(), {{{0, -1, 2}, {1, -1, 2}, {0.5, 3, 32}}}, BoundedPrecision{.eps_px = step});
    const CornersWorld p = corners_of(steep.t.scene, 0);
    const auto wrong_at = [&](double of_third, double aside) {
        const glm::dvec3 at = (1 - of_third) / 2 * glm::dvec3(p[0] + p[1]) + of_third * glm::dvec3(p[2]);
        return steep.wrong(position_x, {at.x + aside, at.y, at.z});
    };
    const double of_third = GetParam() == Projection::perspective ? 3.0 / 83 : 1.5 / 4;
    EXPECT_FALSE(wrong_at(of_third, 0));
    const double px = GetParam() == Projection::perspective ? 2 + 30 * of_third : 1;
    EXPECT_FALSE(wrong_at(of_third, 0.99 * step * px));
    const auto wrong = wrong_at(of_third, 1.01 * step * px);
    ASSERT_TRUE(wrong);
    EXPECT_EQ(wrong->channel, position_x);
    EXPECT_GT(wrong->error_over_bound, 1);
}

}  // namespace
}  // namespace zproof
