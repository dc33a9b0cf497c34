#include "math/vector3.h"

#include <gtest/gtest.h>

#include "doubles.h"
#include "math/rational.h"

namespace zproof {
namespace {

using Vector = Vector3<Rational>;

bool equal(const Vector& a, const Vector& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

Vector random_vector(std::mt19937_64& random) {
    const auto next = [&] { return random_double(random, -4, 4); };
    const double x = next(), y = next();
    return {Rational(x), Rational(y), Rational(next())};
}

TEST(Vector3, AddsSubtractsAndScalesByComponents) {
    const Vector a{1, 2, 3}, b{10, 20, 30};
    EXPECT_TRUE(equal(a + b, {11, 22, 33}));
    EXPECT_TRUE(equal(b - a, {9, 18, 27}));
    EXPECT_TRUE(equal(Rational(2) * a, {2, 4, 6}));
    EXPECT_EQ(dot(a, b), 140);
}

TEST(Vector3, TheCrossProductOfTwoAxesIsTheThird) {
    const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    EXPECT_TRUE(equal(cross(x, y), z));
    EXPECT_TRUE(equal(cross(y, z), x));
    EXPECT_TRUE(equal(cross(z, x), y));
}

TEST(Vector3, TheCrossProductIsPerpendicularAndAsLongAsItsArea) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100; ++i) {
        const Vector a = random_vector(random), b = random_vector(random), c = cross(a, b);
        ASSERT_EQ(dot(a, c), 0);
        ASSERT_EQ(dot(b, c), 0);
        ASSERT_EQ(dot(c, c), dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b));
        ASSERT_TRUE(equal(cross(b, a), Rational(-1) * c));
    }
}

TEST(Vector3, TakesMachineNumbersWithoutLoss) {
    const Vector v = exactly<Rational>(glm::dvec3(0.1, -1e-300, 1e300));
    EXPECT_TRUE(equal(v, {Rational(0.1), Rational(-1e-300), Rational(1e300)}));
}

}  // namespace
}  // namespace zproof
