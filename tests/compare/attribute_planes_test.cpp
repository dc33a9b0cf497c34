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
constexpr int width = 1920, height_px = 16;

RasterPrecision planes(int subpixel_bits) {
    return {.transform = Arithmetic::float64,
            .subpixel_bits = subpixel_bits,
            .depth_interpolation = DepthInterpolation::plane,
            .depth_roundings = 1};
}

/// A corner as float32 has it.
struct PlaneCorner {
    float x, y, weight;
};

/// The value at a pixel's centre of the plane through these: gradients by Cramer's rule, then an offset at
/// the window's corner.
float on_plane(const std::array<PlaneCorner, 3>& p, const std::array<float, 3>& value, int x, int y) {
    const float dx01 = p[0].x - p[1].x, dy01 = p[0].y - p[1].y, dx20 = p[2].x - p[0].x,
                dy20 = p[2].y - p[0].y;
    const float one_over_area = 1 / (dx01 * dy20 - dx20 * dy01);
    const float rise01 = value[0] - value[1], rise20 = value[2] - value[0];
    const float per_x = rise01 * (dy20 * one_over_area) - rise20 * (dy01 * one_over_area);
    const float per_y = rise20 * (dx01 * one_over_area) - rise01 * (dx20 * one_over_area);
    const float at_origin = value[0] - (per_x * (p[0].x - 0.5f) + per_y * (p[0].y - 0.5f));
    return (at_origin + per_x * float(x)) + per_y * float(y);
}

/// The plane of products over that of weights.
float by_products(const std::array<PlaneCorner, 3>& p, const std::array<float, 3>& v, int x, int y) {
    return on_plane(p, {v[0] * p[0].weight, v[1] * p[1].weight, v[2] * p[2].weight}, x, y) /
           on_plane(p, {p[0].weight, p[1].weight, p[2].weight}, x, y);
}

/// By the shares of two corners.
float by_shares(const std::array<PlaneCorner, 3>& p, const std::array<float, 3>& v, int x, int y) {
    const float weight = on_plane(p, {p[0].weight, p[1].weight, p[2].weight}, x, y);
    const float i = on_plane(p, {0, p[1].weight, 0}, x, y) / weight,
                j = on_plane(p, {0, 0, p[2].weight}, x, y) / weight;
    return v[0] + i * (v[1] - v[0]) + j * (v[2] - v[0]);
}

/// A triangle from a pixel to 1000; half of them are slivers through a pixel's centre. Values are of one size
/// or of any.
struct Random {
    Triangle triangle;
    std::array<float, 3> value;
    int x, y;  ///< a pixel that the triangle should hold

    explicit Random(Rng& rng) {
        const double size = std::exp2(rng.between(0, 9)), turn = rng.between(0, 6.3);
        const double height = rng.below(2) == 0 ? size : std::exp2(-rng.between(0, 10));
        const double middle = rng.below(2) * 100;
        x = int(rng.between(600, width - 600)), y = rng.below(height_px);
        const double shares[] = {rng.between(0, 1), rng.between(0, 1), rng.between(0.1, 1)};
        const double along[] = {-size, size, rng.between(-size, size)}, across[] = {0, 0, height};
        const double sum = shares[0] + shares[1] + shares[2];
        double a = 0, c = 0;  // of the place in the triangle that becomes the centre
        for (std::size_t i = 0; i < 3; ++i) a += shares[i] / sum * along[i], c += shares[i] / sum * across[i];
        for (std::size_t i = 0; i < 3; ++i) {
            const double u = along[i] - a, v = across[i] - c;
            triangle[i] = {x + 0.5 + u * std::cos(turn) - v * std::sin(turn),
                           y + 0.5 + u * std::sin(turn) + v * std::cos(turn), rng.between(1, 8)};
            value[i] = float(middle + rng.between(-1, 1));
        }
    }
};

double area_px2(const Triangle& t) {
    const auto& [p, q, r] = t;
    return std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
}

double snapped(double px, int bits) { return std::ldexp(std::nearbyint(std::ldexp(px, bits)), -bits); }

/// May the triangle's uv be no number at that pixel?
bool may_be_nothing(TestScene t, const Precision& precision, const PixelCoord& pixel) {
    const Resolution size = t.candidate.size();
    answer_everywhere(t.candidate, 0, 1);
    t.scene.vertices.uv.push_back({{0, 0}, {1, 0}, {0, 1}});
    for (const std::size_t channel : {uv_u, uv_v})
        t.candidate.attributes.planes[channel] = Plane<float>(size, NAN);
    const CheckedAttributes said = AttributeCheck(t.scene, t.view, t.candidate, precision).at(pixel);
    EXPECT_EQ(said.is_open, !said.wrong);
    return said.is_open;
}

RasterPrecision clipping_at(Clipping clipping) {
    RasterPrecision precision = planes(8);
    precision.clipping = clipping;
    return precision;
}

class ValuesOfPlanes : public testing::TestWithParam<Projection> {
  protected:
    bool is_perspective() const { return GetParam() == Projection::perspective; }

    /// Where the scene's corners are seen, which float32 has moved a little.
    Triangle seen(const Scene& scene) const {
        Triangle t;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 p(scene.vertices.position_world[scene.triangles[0][int(i)]]);
            const double scale = is_perspective() ? -p.z : 1;
            t[i] = {p.x / scale, -p.y / scale, -p.z};
        }
        return t;
    }
    std::array<PlaneCorner, 3> corners_of(const Triangle& t) const {
        std::array<PlaneCorner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = {float(t[i].x), float(t[i].y), is_perspective() ? 1 / float(t[i].depth) : 1};
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
    int judged = 0, thin = 0, unknown = 0;
    double largest_share = 0;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        Rng rng(seed);
        const Random random(rng);
        const int bits = seed % 2 == 0 ? 8 : 16, x = random.x, y = random.y;
        TestScene t(GetParam(), width, height_px, {random.triangle});
        const Triangle exact = seen(t.scene), snapped = snapped_to(bits, exact);
        if (!covers(snapped, x, y)) continue;
        t.scene.vertices.uv.push_back({});
        for (const float v : random.value) t.scene.vertices.uv[0].push_back({v, 0});
        answer(t.candidate, x, y, 0, exact[0].depth);
        for (const std::size_t channel : {uv_u, uv_v})
            t.candidate.attributes.planes[channel] = Plane<float>({width, height_px}, 0);
        const AttributeCheck check(t.scene, t.view, t.candidate, planes(bits));
        const auto is_wrong = [&](double given) {
            t.candidate.attributes.planes[uv_u].at(x, y) = float(given);
            return check.at({x, y}).wrong;
        };
        const auto bound = is_wrong(1e30);
        ++(bound ? judged : unknown);
        thin += bound && area_px2(exact) < 1;
        for (const Triangle& set_up : {exact, snapped})
            for (const auto way : {by_products, by_shares}) {
                const float given = way(corners_of(set_up), random.value, x, y);
                EXPECT_FALSE(is_wrong(given)) << given;
                if (!bound) continue;
                const double room =
                    given > bound->truth ? bound->high - bound->truth : bound->truth - bound->low;
                largest_share = std::max(largest_share, std::abs(given - bound->truth) / room);
            }
        if (!bound) continue;
        const auto inwards = [&](double end) { return std::nextafter(float(end), float(bound->truth)); };
        EXPECT_FALSE(is_wrong(inwards(bound->high)));
        EXPECT_FALSE(is_wrong(inwards(bound->low)));
        const double ulp = std::max(std::abs(bound->low), std::abs(bound->high)) * 0x1p-23;
        EXPECT_TRUE(is_wrong(bound->high + 0.01 * (bound->high - bound->truth) + ulp));
        EXPECT_TRUE(is_wrong(bound->low - 0.01 * (bound->truth - bound->low) - ulp));
    }
    EXPECT_GT(judged, 1500);
    EXPECT_GT(thin, 100);
    EXPECT_GT(unknown, 50);
    EXPECT_LE(largest_share, 1);
    EXPECT_GT(largest_share, 0.2);
}

/// An area that rounding may take says nothing of the plane: not even that there is one.
TEST_P(ValuesOfPlanes, OfATriangleWithoutAreaMayBeNoNumber) {
    const RasterPrecision precision{.depth_interpolation = DepthInterpolation::plane};
    const Triangle line{{{2, 2, 1}, {6, 6, 1}, {4, 4 + 0x1p-18, 1}}},
        plain{{{2, 2, 1}, {6, 2, 1}, {4, 6, 1}}};
    EXPECT_TRUE(may_be_nothing({GetParam(), 8, 8, {line}}, precision, {4, 4}));
    EXPECT_FALSE(may_be_nothing({GetParam(), 8, 8, {plain}}, precision, {4, 4}));
}

/// Where rounding may cut a corner off, pieces may be as thin as any.
TEST_P(ValuesOfPlanes, WithACornerOnAPlaneThatClipsMayBeNoNumber) {
    const Triangle inside{{{1, 1, 1}, {7, 1, 1}, {1, 7, 1}}}, at_side{{{1, 1, 1}, {8, 1, 1}, {1, 7, 1}}},
        at_near{{{1, 1, 1}, {7, 1, 0.25}, {1, 7, 1}}};
    for (const Clipping clipping : {Clipping::guard_band, Clipping::view_volume}) {
        const auto at = [&](const Triangle& triangle) {
            return may_be_nothing({GetParam(), 8, 8, {triangle}}, clipping_at(clipping), {2, 2});
        };
        EXPECT_FALSE(at(inside));
        EXPECT_EQ(at(at_side), clipping == Clipping::view_volume);
        EXPECT_TRUE(at(at_near));
    }
}

/// A side cuts a tip off and leaves two corners that snapping may join. Pieces with both lie along the edges:
/// elsewhere the plane is known.
TEST_P(ValuesOfPlanes, AreUnknownOnlyWhereAThinPieceMayBe) {
    const TestScene t(GetParam(), 8, 8, {{{{1, 1, 1}, {8.0001, 4, 1}, {1, 7, 1}}}});
    const RasterPrecision precision = clipping_at(Clipping::view_volume);
    EXPECT_TRUE(may_be_nothing(t, precision, {4, 5})) << "its centre is on an edge";
    EXPECT_FALSE(may_be_nothing(t, precision, {2, 2}));
    EXPECT_FALSE(may_be_nothing(t, precision, {3, 3}));
}

/// A weight of a millionth of the others' is less than what rounding may take of their plane: it may be 0.
TEST(WeightsOfPlanes, ThatMayVanishLeaveNoNumber) {
    TestScene t(Projection::perspective, 16, 16,
                {{{{-500, 12, 1}, {500, 12, 1}, {8.5, 4.5 - 0x1p-16, 0x1p29}}}});
    t.view.camera.far_depth = 0x1p30;
    EXPECT_TRUE(may_be_nothing(t, planes(16), {8, 4}));
    EXPECT_FALSE(may_be_nothing(t, planes(16), {8, 10}));
}

/// What is too small for float32 may be 0, also where weights are large.
TEST_P(ValuesOfPlanes, MayUnderflow) {
    TestScene t(GetParam(), 8, 8, {wall(1.0 / 32)});
    t.view.camera.near_depth = 1.0 / 64;
    answer_everywhere(t.candidate, 0, 1.0 / 32);
    t.scene.vertices.uv.assign(1, {3, {1e-38f, 1e-36f}});
    for (const std::size_t channel : {uv_u, uv_v})
        t.candidate.attributes.planes[channel] = Plane<float>({8, 8}, 0);
    const auto wrong = AttributeCheck(t.scene, t.view, t.candidate, planes(8)).at({2, 2}).wrong;
    ASSERT_TRUE(wrong);
    EXPECT_EQ(wrong->channel, uv_v);
}

/// A right triangle of 64 px by 1: the edges reach 64, 1 and 65 px in x and in y. Twice the area is 64, of
/// which the snap may take 2 / 512 of the longer two, and a little. At the far corner a weight is a quarter
/// of the largest one in a perspective.
TEST_P(ValuesOfPlanes, LieOutsideTheTriangleByTheSnap) {
    const double far = is_perspective() ? 4 : 1;
    TestScene t(GetParam(), 128, 16, {{{{8, 8, far}, {72, 8, 1}, {8, 9, 1}}}});
    const ViewFacts facts(t.view);
    const ViewBounds bounds(t.view, varying_precision(planes(8)));
    const Surface surface = surface_at(facts, bounds, zproof::corners_of(t.scene, 0), {8, 8});
    const double share = is_perspective() ? surface.least_inverse_depth : 1;
    const double area = 64 - 2 * 129.0 / 512 - 8.0 / (512 * 512),
                 by_hand = (130 + 6.0 / 512) / (512 * area) / 2;
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
