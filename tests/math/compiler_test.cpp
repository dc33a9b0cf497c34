// What every bound of this project takes for granted of the compiler, and one that was found to break it.
#include <gtest/gtest.h>

#include <array>

namespace zproof {
namespace {

struct Two {
    double first, second;
};

Two rounded_to_float32(double a, double b) {
    const float first = float(a / 3), second = float(b / 7);
    return {first, second};
}

/// Called through a pointer that may change, so that no compiler knows its arguments.
Two (*volatile two_of)(double, double) = rounded_to_float32;

/// g++ 12.2 from -O2 on: 1/3 and 1/7 come back with all the digits of double.
TEST(Compiler, RoundsNeighboursToFloat32) {
    const Two two = two_of(1, 1);
    EXPECT_EQ(two.first, 0x1.555556p-2);
    EXPECT_EQ(two.second, 0x1.24924ap-3);
}

double product_and_sum(double a, double b, double c) { return a * b + c; }
double (*volatile sum_of)(double, double, double) = product_and_sum;

TEST(Compiler, DoesNotContract) { EXPECT_EQ(sum_of(0x1.0000001p0, 0x1.0000001p0, -0x1.0000002p0), 0); }

}  // namespace
}  // namespace zproof
