#include "filters/conformance/permitted_interval.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace zproof {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

ColourRange grey(double low, double high) { return {glm::dvec3{low}, glm::dvec3{high}}; }

LinearRgb grey(float value) { return {value, value, value}; }

PermittedInterval interval_of(const LinearRgb& colour, const PermittedColours& permitted) {
    return permitted_interval(Picture({1, 1}, colour),
                              [&](int, int, const FilterPrecision&) { return permitted; }, {});
}

double distance(const LinearRgb& colour, const PermittedColours& permitted) {
    const auto [least, greatest] = interval_of(colour, permitted);
    return distance_outside(colour, least.at(0, 0), greatest.at(0, 0));
}

/// 0.1 is no float32: its float32 lies above it.
TEST(PermittedInterval, EndsInTheOutermostFloatsThatArePermitted) {
    const auto [least, greatest] = interval_of(grey(0.1f), {grey(0.1, 0.5)});
    EXPECT_EQ(least.at(0, 0), grey(0.1f));
    EXPECT_EQ(greatest.at(0, 0), grey(0.5f));
    const auto above = interval_of(grey(0), {grey(-0.5, 0.1)});
    EXPECT_EQ(above.greatest.at(0, 0), grey(std::nextafter(0.1f, 0.0f)));
}

/// The middle range is the nearest; the last one holds red and green only.
TEST(PermittedInterval, IsThatOfTheNearestRange) {
    const PermittedColours permitted{grey(0, 0.25), grey(0.5, 0.75), {{0.4, 0.4, 4}, {0.5, 0.5, 5}}};
    const auto [least, greatest] = interval_of(grey(0.4375f), permitted);
    EXPECT_EQ(least.at(0, 0), grey(0.5f));
    EXPECT_EQ(greatest.at(0, 0), grey(0.75f));
}

TEST(DistanceOutside, IsThatOfTheWorstChannel) {
    EXPECT_EQ(distance({0.5f, 0.75f, 0.625f}, {grey(0.5, 0.75)}), 0);
    EXPECT_EQ(distance({0.5f, 1, 0.375f}, {grey(0.5, 0.75)}), 0.25);
    EXPECT_EQ(distance(grey(7), {grey(-double{inf}, double{inf})}), 0) << "anything is permitted";
}

TEST(DistanceOutside, IsInfiniteForNoNumberAndWhereNoFloatIsPermitted) {
    EXPECT_EQ(distance({nan, 0.5f, 0.5f}, {grey(0, 1)}), double{inf});
    EXPECT_EQ(distance(grey(inf), {grey(-double{inf}, double{inf})}), double{inf});
    EXPECT_EQ(distance(grey(0.1f), {grey(0.1, std::nextafter(0.1, 1.0))}), double{inf});
}

}  // namespace
}  // namespace zproof
