#include "math/affine.h"

#include <gtest/gtest.h>

#include "math/rational.h"

namespace zproof {
namespace {

using Functional = Affine<Rational>;

Rational at(const Functional& f) { return f.at(Rational(5), Rational(7)); }

TEST(Affine, IsAxPlusByPlusC) {
    EXPECT_EQ(at({2, 0, 0}), 10);
    EXPECT_EQ(at({0, 3, 0}), 21);
    EXPECT_EQ(at({0, 0, 4}), 4);
    EXPECT_EQ(at({2, 3, 4}), 35);
}

TEST(Affine, SumsDifferencesAndMultiplesAreThoseOfTheValues) {
    const Functional f{2, -3, 4}, g{-1, 9, 8};
    EXPECT_EQ(at(f + g), at(f) + at(g));
    EXPECT_EQ(at(f - g), at(f) - at(g));
    EXPECT_EQ(at(-f), -at(f));
    EXPECT_EQ(at(Rational(6) * f), 6 * at(f));
}

}  // namespace
}  // namespace zproof
