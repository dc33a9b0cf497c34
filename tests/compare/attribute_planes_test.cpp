/// Values that a plane equation interpolates: a renderer that does it in float32, step by step, keeps the
/// promise of such a renderer, and what lies a hundredth beyond the bound does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compare/attributes/attribute_check.h"
#include "random_surroundings.h"
#include "test_scene.h"

namespace zproof {
namespace {

constexpr std::size_t uv_u = 2, uv_v = 3;
constexpr int width = 1920, height = 1080;

RasterPrecision planes(int subpixel_bits) {
    return {.transform = Arithmetic::float64,
            .subpixel_bits = subpixel_bits,
            .depth_interpolation = DepthInterpolation::plane,
            .depth_roundings = 1};
}

/// A corner as float32 has it, and what is interpolated from it.
struct PlaneCorner {
    float x, y, weight, product;
};

/// The plane's value at a pixel's centre: gradients by Cramer's rule, then an offset at the window's corner.
float on_plane(const std::array<PlaneCorner, 3>& p, float PlaneCorner::*value, int x, int y) {
    const float dx01 = p[0].x - p[1].x, dy01 = p[0].y - p[1].y, dx20 = p[2].x - p[0].x,
                dy20 = p[2].y - p[0].y;
    const float one_over_area = 1 / (dx01 * dy20 - dx20 * dy01);
    const float rise01 = p[0].*value - p[1].*value, rise20 = p[2].*value - p[0].*value;
    const float per_x = rise01 * (dy20 * one_over_area) - rise20 * (dy01 * one_over_area);
    const float per_y = rise20 * (dx01 * one_over_area) - rise01 * (dx20 * one_over_area);
    const float at_origin = p[0].*value - (per_x * (p[0].x - 0.5f) + per_y * (p[0].y - 0.5f));
    return (at_origin + per_x * float(x)) + per_y * float(y);
}

/// A triangle within the image, from a pixel to its whole height, some thin; values of one size or of any.
struct Random {
    Triangle triangle;
    std::array<double, 3> value;

    explicit Random(Rng& rng) {
        const double size = std::exp2(rng.between(0, 9)), thin = std::exp2(-rng.between(0, 7));
        const double x = rng.between(600, width - 600), y = height / 2.0;
        const double middle = rng.below(2) * 100;
        for (std::size_t i = 0; i < 3; ++i) {
            const double across = rng.between(-size, size);
            triangle[i] = {float(x + across), float(y + (rng.between(-size, size) + across) * thin),
                           std::exp2(rng.below(4))};
            value[i] = float(middle + rng.between(-1, 1));
        }
    }
};

double snapped(double px, int bits) { return std::ldexp(std::nearbyint(std::ldexp(px, bits)), -bits); }

class ValuesOfPlanes : public testing::TestWithParam<Projection> {
  protected:
    bool is_perspective() const { return GetParam() == Projection::perspective; }

    std::array<PlaneCorner, 3> corners_of(const Triangle& t, const std::array<double, 3>& value) const {
        std::array<PlaneCorner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const float weight = is_perspective() ? 1 / float(t[i].depth) : 1;
            corners[i] = {float(t[i].x), float(t[i].y), weight, float(value[i]) * weight};
        }
        return corners;
    }

    static Triangle snapped_to(int bits, Triangle t) {
        for (Corner& c : t) c = {snapped(c.x, bits), snapped(c.y, bits), c.depth};
        return t;
    }

    /// Is the pixel's centre in the triangle?
    static bool covers(const Triangle& t, int x, int y) {
        std::array<double, 3> side{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner &p = t[i], &q = t[(i + 1) % 3];
            side[i] = (q.x - p.x) * (y + 0.5 - p.y) - (q.y - p.y) * (x + 0.5 - p.x);
        }
        return std::ranges::min(side) > 0 || std::ranges::max(side) < 0;
    }
};

INSTANTIATE_TEST_SUITE_P(Projections, ValuesOfPlanes,
                         testing::Values(Projection::perspective, Projection::parallel),
                         [](const auto& projection) {
                             return projection.param == Projection::perspective ? "Perspective" : "Parallel";
                         });

/// Drivers may set planes up before corners are snapped, or afterwards.
TEST_P(ValuesOfPlanes, InFloat32KeepTheirPromiseAndBeyondItAreWrong) {
    int judged = 0, unknown = 0;
    double largest_share = 0;
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const Random random(rng);
        const int bits = seed % 2 == 0 ? 8 : 16;
        const Triangle snapped = snapped_to(bits, random.triangle);
        TestScene t(GetParam(), width, height, {random.triangle});
        t.scene.vertices.uv.push_back({});
        for (const double v : random.value) t.scene.vertices.uv[0].push_back({float(v), 0});
        for (const std::size_t channel : {uv_u, uv_v})
            t.candidate.attributes.planes[channel] = Plane<float>({width, height}, 0);
        const AttributeCheck check(t.scene, t.view, t.candidate, planes(bits));
        for (int k = 0; k < 40; ++k) {
            const auto& [p, q, r] = random.triangle;
            const int x = int(p.x + rng.between(-1, 1) * (q.x - p.x));
            const int y = int(p.y + rng.between(-1, 1) * (r.y - p.y));
            if (x < 0 || y < 0 || x >= width || y >= height || !covers(snapped, x, y)) continue;
            answer(t.candidate, x, y, 0, random.triangle[0].depth);
            float& value = t.candidate.attributes.planes[uv_u].at(x, y);
            const auto is_wrong = [&](double given) {
                value = float(given);
                return check.first_wrong({x, y});
            };
            for (const Triangle& set_up : {random.triangle, snapped}) {
                const auto corners = corners_of(set_up, random.value);
                const float given = on_plane(corners, &PlaneCorner::product, x, y) /
                                    on_plane(corners, &PlaneCorner::weight, x, y);
                EXPECT_FALSE(is_wrong(given)) << x << ", " << y << ": " << given;
                const auto bound = is_wrong(1e30);
                if (!bound) {
                    ++unknown;
                    continue;
                }
                ++judged;
                const double up = bound->high - bound->truth, down = bound->truth - bound->low;
                largest_share = std::max(largest_share, given > bound->truth ? (given - bound->truth) / up
                                                                             : (bound->truth - given) / down);
                const auto inwards = [&](double end) {
                    return std::nextafter(float(end), float(bound->truth));
                };
                EXPECT_FALSE(is_wrong(inwards(bound->high)));
                EXPECT_FALSE(is_wrong(inwards(bound->low)));
                const double ulp = std::max(std::abs(bound->low), std::abs(bound->high)) * 0x1p-23;
                EXPECT_TRUE(is_wrong(bound->high + 0.01 * up + ulp));
                EXPECT_TRUE(is_wrong(bound->low - 0.01 * down - ulp));
            }
        }
    }
    EXPECT_GT(judged, 1000);
    EXPECT_LT(unknown, judged / 4);
    EXPECT_LE(largest_share, 1);
    EXPECT_GT(largest_share, 0.3);
}

/// An area that rounding may take says nothing of the plane: not even that there is one.
TEST_P(ValuesOfPlanes, OfATriangleWithoutAreaMayBeNoNumber) {
    const Triangle line{{{2, 2, 1}, {6, 6, 1}, {4, 4 + 0x1p-18, 1}}},
        plain{{{2, 2, 1}, {6, 2, 1}, {4, 6, 1}}};
    for (const auto& [triangle, is_known] : {std::pair{line, false}, {plain, true}}) {
        TestScene t(GetParam(), 8, 8, {triangle});
        answer_everywhere(t.candidate, 0, 1);
        t.scene.vertices.uv.push_back({{0, 0}, {1, 0}, {0, 1}});
        for (const std::size_t channel : {uv_u, uv_v})
            t.candidate.attributes.planes[channel] = Plane<float>({8, 8}, NAN);
        const AttributeCheck check(t.scene, t.view, t.candidate,
                                   RasterPrecision{.depth_interpolation = DepthInterpolation::plane});
        EXPECT_EQ(check.first_wrong({4, 4}).has_value(), is_known);
    }
}

/// A right triangle of 64 px by 1: the edges reach 64, 1 and 65 px in x and in y, twice the area is 64. At
/// the far corner a weight is a quarter of the largest one in a perspective.
TEST_P(ValuesOfPlanes, LieOutsideTheTriangleByTheSnap) {
    const double far = is_perspective() ? 4 : 1;
    TestScene t(GetParam(), 128, 16, {{{{8, 8, far}, {72, 8, 1}, {8, 9, 1}}}});
    const ViewFacts facts(t.view);
    const ViewBounds bounds(t.view, varying_precision(planes(8)));
    const Surface surface = surface_at(facts, bounds, zproof::corners_of(t.scene, 0), {8, 8});
    const double share = is_perspective() ? surface.least_inverse_depth : 1, by_hand = 130.0 / (512 * 64) / 2;
    if (is_perspective()) {
        EXPECT_NEAR(share, 1 - 0.75 * (0.5 - 0.5 / 64), 0.01);
    }
    EXPECT_NEAR(interpolation_errors(planes(8), surface, 1).negative, by_hand / share, 1e-6);
}

TEST_P(ValuesOfPlanes, ArePromisedWhereEdgesAreExact) {
    RasterPrecision precision = planes(8);
    EXPECT_TRUE(promises_attributes(precision, GetParam()));
    precision.edge_functions = EdgeFunctions::from_corner;
    EXPECT_FALSE(promises_attributes(precision, GetParam()));
    precision.edge_functions = EdgeFunctions::exact;
    precision.barycentric_tolerance = 1e-6;
    EXPECT_FALSE(promises_attributes(precision, GetParam()));
}

}  // namespace
}  // namespace zproof
