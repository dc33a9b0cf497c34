#include "compare/picture_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace zproof {
namespace {

TEST(PictureDifference, IsToldClassByClass) {
    Picture a({2, 2}), b({2, 2});
    Plane<PixelClass> classes({2, 2}, PixelClass::agree);
    classes.at(1, 1) = PixelClass::edge;
    b.at(0, 0) = {0.5f, 0, 0};
    b.at(1, 1) = {1, 1, 0.25f};
    const PictureDifferences d = differences(a, b, classes);
    const PictureDifference& agree = d[std::size_t(PixelClass::agree)];
    const PictureDifference& edge = d[std::size_t(PixelClass::edge)];
    EXPECT_EQ(agree.pixels, 3u);
    EXPECT_EQ(agree.largest, 0.5);
    EXPECT_NEAR(agree.mean, 0.5 / 9, 1e-15);
    EXPECT_NEAR(agree.rms, std::sqrt(0.25 / 9), 1e-15);
    EXPECT_EQ(edge.pixels, 1u);
    EXPECT_NEAR(edge.mean, 0.75, 1e-15);
    EXPECT_EQ(d[std::size_t(PixelClass::hole)].pixels, 0u);
    EXPECT_EQ(d[std::size_t(PixelClass::hole)].rms, 0);
}

TEST(PictureDifference, DoesNotHideNaN) {
    Picture a({2, 1}), b({2, 1});
    b.at(1, 0).g = std::numeric_limits<float>::quiet_NaN();
    const PictureDifferences d = differences(a, b, Plane<PixelClass>({2, 1}, PixelClass::agree));
    EXPECT_TRUE(std::isinf(d[0].largest));
    EXPECT_TRUE(std::isinf(d[0].rms));
}

TEST(PictureDifference, RefusesPlanesOfDifferentSizes) {
    EXPECT_THROW(differences(Picture({2, 1}), Picture({1, 2}), Plane<PixelClass>({2, 1})),
                 std::invalid_argument);
    EXPECT_THROW(severer(Plane<PixelClass>({2, 1}), Plane<PixelClass>({1, 1})), std::invalid_argument);
}

TEST(PictureDifference, MasksByTheSevererClass) {
    Plane<PixelClass> a({2, 1}, PixelClass::agree), b({2, 1}, PixelClass::edge);
    a.at(1, 0) = PixelClass::hidden;
    EXPECT_EQ(severer(a, b).at(0, 0), PixelClass::edge);
    EXPECT_EQ(severer(a, b).at(1, 0), PixelClass::hidden);
}

}  // namespace
}  // namespace zproof
