#include "compare/admissible/coplanar.h"

#include <gtest/gtest.h>

#include <limits>

#include "math/rational.h"
#include "math/vector3.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

using Vector = Vector3<Rational>;

Vector exact(const glm::vec3& p) { return exactly<Rational>(glm::dvec3(p)); }

bool coplanar_in_rationals(const CornersWorld& a, const CornersWorld& b) {
    const Vector o = exact(a[0]), normal = cross(exact(a[1]) - o, exact(a[2]) - o);
    for (const glm::vec3& p : b)
        if (dot(normal, exact(p) - o) != 0) return false;
    return true;
}

/// Small whole coordinates are coplanar often; a common power of two takes them to any magnitude.
CornersWorld random_triangle(Rng& rng, float scale) {
    CornersWorld p;
    for (glm::vec3& corner : p)
        corner = scale * glm::vec3(float(rng.below(4)), float(rng.below(4)), float(rng.below(3)));
    return p;
}

TEST(Coplanar, SaysWhatRationalsSayAtEveryMagnitude) {
    Rng rng(1);
    int yes = 0;
    for (int i = 0; i < 4000; ++i) {
        const float scale = std::ldexp(1.f, rng.below(2) ? 0 : rng.below(270) - 148);
        const CornersWorld a = random_triangle(rng, scale);
        CornersWorld b = random_triangle(rng, scale);
        if (rng.below(4) == 0) b[0].z = std::nextafter(b[0].z, std::numeric_limits<float>::max());
        ASSERT_EQ(coplanar(a, b), coplanar_in_rationals(a, b)) << i;
        yes += coplanar(a, b);
    }
    EXPECT_GT(yes, 100);
    EXPECT_LT(yes, 3900);
}

TEST(Coplanar, OneUlpOffThePlaneIsOff) {
    const CornersWorld floor{{{0, 0, 0}, {1e30f, 0, 0}, {0, 1e30f, 0}}};
    EXPECT_TRUE(coplanar(floor, {{{1, 1, 0}, {-1e-30f, 3, 0}, {7, -7, 0}}}));
    EXPECT_FALSE(coplanar(floor, {{{1, 1, 0}, {2, 3, 0}, {7, -7, 1e-45f}}}));
}

/// The slopes of segments of one line differ by their roundings.
TEST(Slope, TellsApartNoSegmentsOfOneLine) {
    Rng rng(7);
    int differing = 0, turned = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto whole = [&] { return std::floor(float(rng.between(-1000, 1000))); };
        const auto any = [&] { return glm::vec3(whole(), whole(), whole()); };
        const glm::vec3 a = any(), d = any();
        const Slope here = slope_of(a, a + d), there = slope_of(a - 7.0f * d, a + 3.0f * d),
                    other = slope_of(a, a + d + glm::vec3(1, 0, 0));
        EXPECT_TRUE(collinear(a, a + d, a - 7.0f * d));
        EXPECT_FALSE(are_turned(here, there));
        differing += here.value != there.value;
        turned += are_turned(here, other);
    }
    EXPECT_GT(differing, 100);
    EXPECT_GT(turned, 900);
    EXPECT_FALSE(are_turned(slope_of({1, 2, 3}, {1, 2, 3}), slope_of({0, 0, 0}, {1, 1, 1})));
}

}  // namespace
}  // namespace zproof
