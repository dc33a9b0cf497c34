#include "math/sign.h"

#include <gtest/gtest.h>

#include <limits>

namespace zproof {
namespace {

TEST(SignOfADouble, IsMinusOneZeroOrOne) {
    EXPECT_EQ(sign(-5e-324), -1);
    EXPECT_EQ(sign(0.0), 0);
    EXPECT_EQ(sign(-0.0), 0);
    EXPECT_EQ(sign(5e-324), 1);
    EXPECT_EQ(sign(-std::numeric_limits<double>::infinity()), -1);
    EXPECT_EQ(sign(std::numeric_limits<double>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace zproof
