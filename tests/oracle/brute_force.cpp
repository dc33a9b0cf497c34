#include "brute_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "math/rounding.h"

namespace zproof::oracle {
namespace {

using Real = long double;
using Vec = glm::vec<3, Real>;

constexpr double u32 = unit_roundoff_float32;

/// A value and what float32 may be off by.
struct Rough {
    Real value, error;

    Real low() const { return value - error; }
    Real high() const { return value + error; }
};

/// What an exact vector is rounded from: float32 differs by at most u32 size, component by component.
struct Rounded {
    Vec at, size;
};

/// The view ray by scenes/camera.h, in long double.
struct ExactRay {
    Rounded origin, direction;
    Real origin_depth;
};

/// The oracle sums in double, where cancellation may leave 4 * 2^-53 of the summands: u32 times 2^-27 of
/// them.
Rounded rounded(const Vec& at, Real summands) { return {at, glm::abs(at) + 0x1p-27L * summands}; }

ExactRay exact_ray(const View& view, int x, int y) {
    const Camera& c = view.camera;
    const Real across = (Real(x) + 0.5L) / Real(view.width), down = (Real(y) + 0.5L) / Real(view.height);
    const Real u = c.window.left + (Real(c.window.right) - c.window.left) * across;
    const Real v = c.window.top - (Real(c.window.top) - c.window.bottom) * down;
    const Real window = std::abs(c.window.left) + std::abs(c.window.right) + std::abs(c.window.bottom) +
                        std::abs(c.window.top);
    const Vec right(c.right), up(c.up), back(c.back), eye(c.eye_world);
    if (c.projection == Projection::perspective) {
        return {
            {eye, Vec(0)}, rounded(u * right + v * up - back, window + 1), 0};  // the eye is float32 already
    }
    const Real shear = std::abs(c.shear.x) + std::abs(c.shear.y), behind = std::min<Real>(c.near_depth, 0);
    const Vec direction = Real(c.shear.x) * right + Real(c.shear.y) * up - back;
    const Real summands = glm::length(eye) + window + std::abs(behind) * (shear + 1);
    return {rounded(eye + u * right + v * up + behind * direction, summands), rounded(direction, shear + 1),
            behind};
}

/// A corner as seen from the ray's origin: 2 roundings, of the origin and of the difference.
Rounded corner(const glm::vec3& position, const ExactRay& ray) {
    const Vec at = Vec(position) - ray.origin.at;
    return {at, glm::abs(at) + ray.origin.size};
}

/// The sum of |terms| of a cross product whose factors are at most `size`, dotted with `other`.
Real all_terms(const Vec& size, const Vec& other) {
    return 2 * glm::dot(Vec(size.y * size.z, size.z * size.x, size.x * size.y), other);
}

/// Embree's edge test  dot(cross(b - a, a + b), D)  (kernels/geometry/triangle_intersector_pluecker.h).
/// Each term passes 13 roundings at most: 3 of b - a, 3 of a + b, 2 of the cross product, 2 of D, 3 of the
/// dot product. FMA only leaves some out.
Rough edge(const Rounded& a, const Rounded& b, const Rounded& direction) {
    return {glm::dot(glm::cross(b.at - a.at, a.at + b.at), direction.at),
            Real(gamma(13, u32)) * all_terms(a.size + b.size, direction.size)};
}

enum class Coverage { none, unsure, full };

/// Embree takes a hit where all three have one sign, or miss it by less than ulp |U + V + W| with ulp = 2 u.
Coverage coverage(const std::array<Rough, 3>& edges) {
    Real slack = 0;
    for (const Rough& e : edges) slack += Real(gamma(3, u32)) * (std::abs(e.value) + e.error);
    const auto certainly_positive = [&](const Rough& e) { return e.low() > slack; };
    const auto certainly_negative = [&](const Rough& e) { return e.high() < -slack; };
    const bool some_positive = std::ranges::any_of(edges, certainly_positive);
    const bool some_negative = std::ranges::any_of(edges, certainly_negative);
    if (some_positive && some_negative) return Coverage::none;
    if (std::ranges::all_of(edges, certainly_positive)) return Coverage::full;
    return std::ranges::all_of(edges, certainly_negative) ? Coverage::full : Coverage::unsure;
}

/// Embree's depth  rcp(dot(N, D)) dot(v0, N),  N the cross product of two edges. Each term of numerator and
/// denominator passes 13 roundings at most: 3 of either edge, 2 of the cross product, 2 of v0 or D, 3 of the
/// dot product. rcp is an estimate of relative error 1.5 * 2^-12 and a Newton step: 2.25 u of the estimate, 3
/// roundings, in all below 6 u; the product is one more. None where the plane is too steep to tell.
std::optional<Rough> depth(const std::array<Rounded, 3>& v, const Rounded& direction) {
    const Vec normal = glm::cross(v[2].at - v[0].at, v[0].at - v[1].at);
    const Vec size = v[0].size + v[1].size + v[2].size;
    const Real many = gamma(13, u32);
    const Rough top{glm::dot(v[0].at, normal), many * all_terms(size, v[0].size)};
    const Rough bottom{glm::dot(direction.at, normal), many * all_terms(size, direction.size)};
    if (std::abs(bottom.value) <= bottom.error) return std::nullopt;
    const Real t = top.value / bottom.value;
    const Real error = (top.error + std::abs(t) * bottom.error) / (std::abs(bottom.value) - bottom.error);
    return Rough{t, error + Real(gamma(7, u32)) * (std::abs(t) + error)};
}

/// What one triangle does to the pixel.
struct Meeting {
    std::uint32_t triangle;
    Coverage coverage;
    Rough t;  ///< along the ray from its origin
};

Coverage within(const Rough& t, const ExactRay& ray, const Camera& camera) {
    const Real near = camera.near_depth - ray.origin_depth, far = camera.far_depth - ray.origin_depth;
    const Real near_error = u32 * std::abs(near), far_error = u32 * std::abs(far);
    if (t.high() < near - near_error || t.low() > far + far_error) return Coverage::none;
    return t.low() > near + near_error && t.high() < far - far_error ? Coverage::full : Coverage::unsure;
}

/// None where the triangle is certainly not seen.
std::optional<Meeting> meet(const Scene& scene, std::uint32_t triangle, const ExactRay& ray,
                            const Camera& camera) {
    const auto at = [&](int i) {
        return corner(scene.vertices.position_world[scene.triangles[triangle][i]], ray);
    };
    const std::array<Rounded, 3> v{at(0), at(1), at(2)};
    const Rounded& d = ray.direction;
    const Coverage inside = coverage({edge(v[0], v[1], d), edge(v[1], v[2], d), edge(v[2], v[0], d)});
    if (inside == Coverage::none) return std::nullopt;
    const std::optional<Rough> t = depth(v, d);
    if (!t) return Meeting{triangle, Coverage::unsure, {0, std::numeric_limits<Real>::infinity()}};
    const Coverage seen = std::min(inside, within(*t, ray, camera));
    if (seen == Coverage::none) return std::nullopt;
    return Meeting{triangle, seen, *t};
}

}  // namespace

std::optional<CertainAnswer> certain_answer(const Scene& scene, const View& view, int x, int y) {
    const ExactRay ray = exact_ray(view, x, y);
    std::vector<Meeting> meetings;
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        if (const auto meeting = meet(scene, i, ray, view.camera)) meetings.push_back(*meeting);
    }
    if (meetings.empty()) return CertainAnswer{};
    const auto by_depth = [](const Meeting& a, const Meeting& b) { return a.t.high() < b.t.high(); };
    const Meeting& first = *std::ranges::min_element(meetings, by_depth);
    const auto may_be_before = [&](const Meeting& m) { return m.t.low() <= first.t.high(); };
    if (first.coverage != Coverage::full || std::ranges::count_if(meetings, may_be_before) != 1)
        return std::nullopt;
    const Real depth = ray.origin_depth + first.t.value;
    return CertainAnswer{PrimitiveId{first.triangle}, depth,
                         first.t.error + Real(u32) * (std::abs(depth) + first.t.error)};
}

namespace {

struct Tally {
    int pixels = 0, certain = 0, certain_and_covered = 0;
};

std::string story(const View& view, int x, int y) {
    return "pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") of " + std::to_string(view.width) +
           " x " + std::to_string(view.height);
}

void expect_certain_answers(const Caster& caster, const Scene& scene, const View& view, Tally& tally) {
    const Frame frame = caster.cast(scene, view);
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            ++tally.pixels;
            const auto expected = certain_answer(scene, view, x, y);
            if (!expected) continue;
            ++tally.certain;
            ASSERT_EQ(frame.primitive.at(x, y), expected->primitive) << story(view, x, y);
            const float depth = frame.camera_depth.at(x, y);
            if (expected->primitive == PrimitiveId::none) {
                ASSERT_EQ(depth, background_depth) << story(view, x, y);
                continue;
            }
            ++tally.certain_and_covered;
            const long double allowed = caster.depth_error ? caster.depth_error(view, double(expected->depth))
                                                           : expected->depth_error;
            ASSERT_LE(std::abs(depth - expected->depth), allowed) << story(view, x, y);
        }
    }
}

}  // namespace

void expect_agreement(const Caster& caster, ProjectionKind projection_kind) {
    Tally tally;
    for (std::uint32_t seed = 0; seed < caster.scenes; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Rng rng(seed);
        const View view = random_view(rng, projection_kind);
        expect_certain_answers(caster, random_soup(rng, view.camera, 40), view, tally);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(tally.certain, tally.pixels * 99 / 100) << "the bounds have become too loose to say anything";
    EXPECT_GT(tally.certain_and_covered, tally.pixels / 3)
        << "the scenes have become too empty to say anything";
}

}  // namespace zproof::oracle
