// Errors by powers of two, and which of them stand alone.
#include "measure/fit/octaves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "measure/fit/verification.h"

namespace zproof::measure {
namespace {

TEST(Octaves, APowerOfTwoEndsItsOctave) {
    EXPECT_EQ(octave_of(0.25), -2);
    EXPECT_EQ(octave_of(std::nextafter(0.25, 1)), -1);
    EXPECT_EQ(octave_of(0), least_octave);
    EXPECT_EQ(octave_of(8), most_octave);
    EXPECT_EQ(octave_of(std::nextafter(8.0, 9)), no_octave);
    EXPECT_EQ(octave_of(std::numeric_limits<double>::infinity()), no_octave);
}

OctaveCounts counts_with(std::uint64_t right) {
    OctaveCounts counts;
    counts.add(least_octave, right);
    return counts;
}

TEST(Octaves, AFewFarAboveMoreStandAlone) {
    OctaveCounts counts = counts_with(10000);
    counts.add(-9, 5);
    counts.add(0, 3);
    EXPECT_EQ(counts.last_before_gap(), -9);
    EXPECT_EQ(counts.greatest(), 0);
    EXPECT_EQ(counts.above(-9), 3u);
}

TEST(Octaves, NeitherMostNorMoreThanAThousandthStandAlone) {
    OctaveCounts most = counts_with(10000);
    most.add(-9, 3);
    most.add(0, 3);
    EXPECT_FALSE(most.last_before_gap());
    OctaveCounts many = counts_with(10000);
    many.add(-9, 100);
    many.add(0, 11);
    EXPECT_FALSE(many.last_before_gap());
}

TEST(Octaves, AFactorOfTenIsAsked) {
    OctaveCounts counts = counts_with(10000);
    counts.add(-9, 5);
    counts.add(-5, 1);
    EXPECT_FALSE(counts.last_before_gap());
    counts = counts_with(10000);
    counts.add(-9, 5);
    counts.add(-4, 1);
    EXPECT_EQ(counts.last_before_gap(), -9);
}

TEST(Octaves, WhatNeedsNothingIsNotTheOthers) {
    OctaveCounts counts = counts_with(1'000'000);
    counts.add(-9, 5);
    EXPECT_FALSE(counts.last_before_gap());
}

TEST(RoundedUp, ThreeDigitsNeverBelow) {
    EXPECT_EQ(rounded_up(0.0021201), 0.00213);
    EXPECT_EQ(rounded_up(0.00212), 0.00212);
    EXPECT_EQ(rounded_up(1234), 1240);
    EXPECT_GE(rounded_up(0x1p-30), 0x1p-30);
}

}  // namespace
}  // namespace zproof::measure
