#include "reports/view_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/class_colour.h"

namespace zproof {

namespace {

constexpr Rgb8 white{255, 255, 255};

LinearRgb white_light(int, int) { return {1, 1, 1}; }

Plane<PixelClass> agreeing(Resolution size) { return Plane<PixelClass>(size, PixelClass::agree); }

/// One triangle everywhere.
Plane<PrimitiveId> one_triangle(Resolution size) { return Plane<PrimitiveId>(size, PrimitiveId(0)); }

Plane<Rgb8> picture_of(const Plane<PixelClass>& classes) {
    return view_picture(classes, one_triangle(classes.size()), white_light, card_picture);
}

double distance(int x, int y, int to_x, int to_y) { return std::hypot(x - to_x, y - to_y); }

TEST(ViewPicture, IsAsLargeAsTheLongestSideOrAWholeMultiple) {
    EXPECT_EQ(resolution_of(card_picture, {1920, 1080}), (Resolution{320, 180}));
    EXPECT_EQ(resolution_of(card_picture, {9000, 1}), (Resolution{320, 1}));
    EXPECT_EQ(resolution_of(card_picture, {100, 60}), (Resolution{300, 180}));
    EXPECT_EQ(resolution_of(card_picture, {321, 200}), (Resolution{320, 199}));
}

TEST(ViewPicture, OfAgreementIsTheLightAlone) {
    const Plane<Rgb8> picture = picture_of(agreeing({640, 360}));
    for (const Rgb8& pixel : picture.pixels()) ASSERT_EQ(pixel, white);
}

TEST(ViewPicture, APixelIsTheMeanOfFourThoseOfOneTriangleShadedOnce) {
    const auto stripes = [](int x, int) { return LinearRgb{float(x % 2), 0, 0}; };
    Plane<PrimitiveId> ids = one_triangle({640, 2});
    for (int x = 320; x < 640; ++x)
        for (int y = 0; y < 2; ++y) ids.at(x, y) = PrimitiveId(std::uint32_t(x % 2));
    const Plane<Rgb8> picture = view_picture(agreeing({640, 2}), ids, stripes, card_picture);
    for (int x = 0; x < 320; ++x)
        ASSERT_EQ(picture.at(x, 0), x < 160 ? (Rgb8{0, 0, 0}) : (Rgb8{188, 0, 0})) << "half of red, in sRGB";
}

/// One wrong pixel of two million is seen by a ring around its place, and by its own colour.
TEST(ViewPicture, AnyLoneDefectHasARing) {
    const Rgb8 colour = colour_of(PixelClass::hole);
    for (const auto& [x, y] :
         {std::pair{960, 540}, std::pair{0, 0}, std::pair{1919, 1079}, std::pair{5, 700}}) {
        Plane<PixelClass> classes = agreeing({1920, 1080});
        classes.at(x, y) = PixelClass::hole;
        const Plane<Rgb8> picture = picture_of(classes);
        for (int j = 0; j < 180; ++j)
            for (int i = 0; i < 320; ++i) {
                const double away = distance(i, j, x / 6, y / 6);
                const bool is_coloured = away == 0 || (away > 4 && away <= 6);
                ASSERT_EQ(picture.at(i, j), is_coloured ? colour : white) << i << ", " << j;
            }
    }
}

TEST(ViewPicture, AnAdmissiblePixelHasAThinnerRingAndKeepsItsLight) {
    Plane<PixelClass> classes = agreeing({320, 180});
    classes.at(100, 90) = PixelClass::edge;
    const Plane<Rgb8> picture = picture_of(classes);
    EXPECT_EQ(picture.at(100, 90), white);
    EXPECT_EQ(picture.at(105, 90), colour_of(PixelClass::edge));
    EXPECT_EQ(picture.at(106, 90), white);
    EXPECT_EQ(picture.at(104, 90), white);
}

TEST(ViewPicture, TheSevererClassIsSeen) {
    Plane<PixelClass> classes = agreeing({640, 360});
    classes.at(200, 200) = PixelClass::edge;
    classes.at(201, 201) = PixelClass::hidden;
    const Plane<Rgb8> picture = picture_of(classes);
    for (const Rgb8& pixel : picture.pixels())
        ASSERT_TRUE(pixel == white || pixel == colour_of(PixelClass::hidden) ||
                    pixel == colour_of(PixelClass::edge));
    EXPECT_EQ(picture.at(100, 100), colour_of(PixelClass::hidden));
    EXPECT_EQ(picture.at(106, 100), colour_of(PixelClass::hidden));
}

TEST(ViewPicture, NeighboursHaveOneOutline) {
    Plane<PixelClass> classes = agreeing({320, 180});
    for (int x = 50; x < 150; ++x) classes.at(x, 90) = PixelClass::outside;
    const Plane<Rgb8> picture = picture_of(classes);
    for (int x = 50; x < 150; ++x) {
        ASSERT_EQ(picture.at(x, 85), colour_of(PixelClass::outside));
        ASSERT_EQ(picture.at(x, 88), white);
        ASSERT_EQ(picture.at(x, 90), colour_of(PixelClass::outside));
    }
}

}  // namespace

}  // namespace zproof
