#include "filters/conformance/sign_probability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace zproof {
namespace {

TEST(SignTest, PositiveNumbersHaveTheChanceOfAsManyHeads) {
    const std::vector<double> ten{1, 2, 3, 4, 5, 6, 7, 8, 9, 1e-3};
    EXPECT_NEAR(log2_chance(ten), -10, 1e-6);
}

TEST(SignTest, NoScaleIsAssumed) {
    const std::vector<double> numbers{3, -1, 2, 2, 4, -0.5, 1, 1, 2, 3};
    std::vector<double> smaller = numbers;
    for (double& x : smaller) x *= 1e-9;
    EXPECT_LT(log2_chance(numbers), -1);
    EXPECT_NEAR(log2_chance(smaller), log2_chance(numbers), 1e-6);
}

TEST(SignTest, ASumOfZeroOrLessIsByChance) {
    EXPECT_EQ(log2_chance(std::vector<double>{1, -1}), 0);
    EXPECT_EQ(log2_chance(std::vector<double>{1, -2, 0.5}), 0);
    EXPECT_EQ(log2_chance(std::vector<double>{}), 0);
}

TEST(SignTest, WhatIsNotFiniteDecidesNothing) {
    EXPECT_EQ(log2_chance(std::vector<double>{1, std::nan(""), 2}), 0);
    EXPECT_EQ(log2_chance(std::vector<double>{1, INFINITY}), 0);
}

/// All 2^n signs by hand: the share of sums that are as large is at most what the bound says.
TEST(SignTest, BoundsTheShareOfSignsWithAsLargeASum) {
    std::mt19937 random{1};
    for (int round = 0; round < 200; ++round) {
        std::vector<double> numbers(10);
        for (double& x : numbers) x = double(random()) / 0x1p32 * std::exp2(int(random() % 8)) - 0.25;
        double sum = 0;
        for (const double x : numbers) sum += x;
        int as_large = 0;
        for (unsigned signs = 0; signs < 1024; ++signs) {
            double other = 0;
            for (unsigned i = 0; i < 10; ++i)
                other += std::abs(numbers[i]) * ((signs >> i & 1) != 0 ? 1 : -1);
            as_large += other >= sum - 1e-12;
        }
        EXPECT_GE(log2_chance(numbers) + 1e-9, std::log2(as_large / 1024.0));
    }
}

}  // namespace
}  // namespace zproof
