/// Hits of float32 rays that are means of the corners by weights: on needles, a weight errs by far more than
/// an edge is displaced.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "compare/admissible/depth_rule.h"
#include "compare/bounds/bounds.h"
#include "math/rational.h"

namespace zproof {
namespace {

using Weights = std::array<float, 3>;

/// As Embree's robust test has them: each is twice the product of its edge with the ray.
Weights by_pluecker(const CornersWorld& v, const glm::vec3& d) {
    Weights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 &from = v[(i + 1) % 3], &to = v[(i + 2) % 3];
        weights[i] = dot(cross(to - from, to + from), d);
    }
    return weights;
}

Weights by_moeller_trumbore(const CornersWorld& v, const glm::vec3& d) {
    const glm::vec3 e1 = v[1] - v[0], e2 = v[2] - v[0], p = cross(d, e2), t = -v[0], q = cross(t, e1);
    const float determinant = dot(e1, p), second = dot(t, p), third = dot(d, q);
    return {determinant - second - third, second, third};
}

/// Along -z.
Weights by_woop(const CornersWorld& v, const glm::vec3& d) {
    std::array<glm::vec2, 3> sheared;
    for (std::size_t i = 0; i < 3; ++i)
        sheared[i] = {v[i].x - d.x / d.z * v[i].z, v[i].y - d.y / d.z * v[i].z};
    Weights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec2 &from = sheared[(i + 1) % 3], &to = sheared[(i + 2) % 3];
        weights[i] = from.x * to.y - from.y * to.x;
    }
    return weights;
}

/// The depth of the hit from an eye at the origin that looks along -z, before it; nothing where none is.
std::optional<float> hit(RayTest test, const CornersWorld& v, const glm::vec3& d) {
    const Weights w = test == RayTest::pluecker           ? by_pluecker(v, d)
                      : test == RayTest::moeller_trumbore ? by_moeller_trumbore(v, d)
                                                          : by_woop(v, d);
    const auto [low, high] = std::ranges::minmax(w);
    const float sum = w[0] + w[1] + w[2];
    if ((low < 0 && high > 0) || sum == 0) return std::nullopt;
    const float z = w[0] / sum * v[0].z + w[1] / sum * v[1].z + w[2] / sum * v[2].z;
    return z < 0 ? std::optional(-z) : std::nullopt;
}

bool is_exactly_hit(const View& view, const CornersWorld& v, const PixelCoord& pixel) {
    const auto image = image_of(ViewRay<Rational>(view, pixel.x, pixel.y), corners<Rational>(v));
    return image && std::ranges::all_of(image->edge, [](const auto& edge) { return sign(edge.c) >= 0; });
}

struct Counted {
    int hits = 0, refused = 0;
};

/// Needles through a pixel's ray that lead away from the eye.
Counted needles_of(RayTest test, HitPoint told) {
    View view;
    view.width = view.height = 16;
    view.camera.window = {-2, 2, -2, 2};
    view.camera.near_depth = 0.01, view.camera.far_depth = 1e4;
    const Precision precision = RayPrecision{.test = test, .watertight = false, .hit_point = told};
    const ViewBounds bounds(view, precision);
    std::mt19937 words(11);
    const auto between = [&](double low, double high) {
        return low + (high - low) * double(words()) / 0x1p32;
    };
    const auto power = [&](double low, double high) {
        return low * std::exp2(between(0, std::log2(high / low)));
    };
    Counted counted;
    for (int i = 0; i < 20'000; ++i) {
        const PixelCoord pixel{int(words() % 16), int(words() % 16)};
        const glm::dvec3 d{-2 + 4 * (pixel.x + 0.5) / 16, 2 - 4 * (pixel.y + 0.5) / 16, -1};
        const glm::dvec3 along{power(1e-6, 1), power(1e-6, 1), -1}, side{power(1e-3, 1), 0, 0};
        const double before = between(0, 0.9), behind = power(1, 100), third = between(-before, behind);
        const CornersWorld v{glm::vec3(d - before * along - 0.3 * side),
                             glm::vec3(d + behind * along - 0.3 * side), glm::vec3(d + third * along + side)};
        const std::optional<float> depth = hit(test, v, glm::vec3(d));
        if (!depth || !is_exactly_hit(view, v, pixel)) continue;
        const TriangleDepth triangle(TriangleInView(view, bounds, v), bounds);
        ++counted.hits;
        counted.refused += !check_depth(view, bounds, v, triangle, pixel, *depth).is_admissible;
    }
    return counted;
}

TEST(RayHits, FromWeightsOnNeedlesLieWithinTheirBound) {
    for (const RayTest test : {RayTest::pluecker, RayTest::moeller_trumbore, RayTest::woop}) {
        const Counted counted = needles_of(test, HitPoint::barycentrics);
        EXPECT_GT(counted.hits, 5'000) << int(test);
        EXPECT_EQ(counted.refused, 0) << int(test);
    }
}

/// Who promises the distance along the ray shows no mean of weights: it lies outside.
TEST(RayHits, FromWeightsAreNotThoseOfDistances) {
    for (const RayTest test : {RayTest::pluecker, RayTest::moeller_trumbore})
        EXPECT_GT(needles_of(test, HitPoint::distance).refused, 10) << int(test);
}

}  // namespace
}  // namespace zproof
