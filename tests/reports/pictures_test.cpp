#include "reports/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "reports/class_style.h"

namespace zproof {

namespace {

/// A letter per pixel: '.' agree, 'e' edge, 'H' hole, 'X' invalid.
std::string drawn(const Plane<PixelClass>& classes) {
    std::string text = "\n";
    for (int y = 0; y < classes.size().height; ++y) {
        for (const PixelClass c : classes.row(y))
            text += c == PixelClass::agree  ? '.'
                    : c == PixelClass::edge ? 'e'
                    : c == PixelClass::hole ? 'H'
                                            : 'X';
        text += '\n';
    }
    return text;
}

Plane<PixelClass> all_agree(Resolution size) { return Plane<PixelClass>(size, PixelClass::agree); }

}  // namespace

TEST(Pictures, OneBadPixelOf1920x1080StaysAsADot) {
    for (const auto& [x, y] : {std::pair{0, 0}, {1919, 1079}, {961, 541}, {3, 1078}}) {
        Plane<PixelClass> classes = all_agree({1920, 1080});
        classes.at(x, y) = PixelClass::hole;
        const Plane<PixelClass> small = small_class_map(classes);
        EXPECT_EQ(small.size(), (Resolution{480, 270}));
        EXPECT_EQ(small.at(x / 4, y / 4), PixelClass::hole);
        EXPECT_GE(std::ranges::count(small.pixels(), PixelClass::hole), 4);
        EXPECT_LE(std::ranges::count(small.pixels(), PixelClass::hole), 9);
    }
}

TEST(Pictures, PoolingKeepsTheSeverest) {
    Plane<PixelClass> classes = all_agree({5, 4});
    classes.at(0, 0) = PixelClass::invalid;
    classes.at(1, 1) = PixelClass::edge;
    classes.at(2, 3) = PixelClass::edge;
    classes.at(4, 3) = PixelClass::hole;
    EXPECT_EQ(drawn(pooled_by_severity(classes, 2)), R"(
X..
.eH
)");
}

TEST(Pictures, DotsGrowDefectsOnlyAndTheSeverestWins) {
    Plane<PixelClass> classes = all_agree({8, 4});
    classes.at(1, 1) = PixelClass::hole;
    classes.at(3, 1) = PixelClass::invalid;
    classes.at(6, 2) = PixelClass::edge;
    EXPECT_EQ(drawn(with_dots(classes)), R"(
HHXXX...
HHXXX...
HHXXX.e.
........
)");
}

TEST(Pictures, SmallViewsAreShownPixelForPixel) {
    Plane<PixelClass> classes = all_agree({16, 16});
    classes.at(7, 7) = PixelClass::hole;
    EXPECT_EQ(drawn(small_class_map(classes)), drawn(classes));
}

TEST(Pictures, ThinningNeverMixesColours) {
    Plane<Rgb8> picture({6, 3});
    for (int x = 0; x < 6; ++x) picture.at(x, 1) = {std::uint8_t(10 * x), 1, 2};
    const Plane<Rgb8> small = thinned(picture, 3);
    EXPECT_EQ(small.size(), (Resolution{2, 1}));
    EXPECT_EQ(small.at(0, 0), (Rgb8{10, 1, 2}));
    EXPECT_EQ(small.at(1, 0), (Rgb8{40, 1, 2}));
}

TEST(Pictures, ShrinkFactorFitsTheLongestSide) {
    EXPECT_EQ(shrink_factor({480, 270}), 1);
    EXPECT_EQ(shrink_factor({481, 270}), 2);
    EXPECT_EQ(shrink_factor({270, 1920}), 4);
    EXPECT_EQ(thinned(Plane<Rgb8>({481, 1}), 2).size(), (Resolution{241, 1}));
}

TEST(Pictures, IdsHaveColoursOfTheirOwnAndBackgroundIsDark) {
    Plane<PrimitiveId> ids({1000, 1});
    for (int x = 0; x < 1000; ++x) ids.at(x, 0) = PrimitiveId(std::uint32_t(x));
    ids.at(999, 0) = PrimitiveId::none;
    const Plane<Rgb8> picture = picture_of_ids(ids);
    std::set<std::tuple<int, int, int>> colours;
    for (const Rgb8 c : picture.pixels()) colours.insert({c.r, c.g, c.b});
    EXPECT_GT(colours.size(), 980u);
    EXPECT_LT(int(picture.at(999, 0).r) + picture.at(999, 0).g + picture.at(999, 0).b, 100);
    for (int x = 0; x < 999; ++x) {
        const Rgb8 c = picture.at(x, 0);
        ASSERT_GT(int(std::max({c.r, c.g, c.b})), 140) << x;
    }
}

TEST(Pictures, DepthsAreLogarithmicAndWhatIsNoDepthIsMagenta) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Plane<float> depths({8, 1});
    const float values[] = {1, 10, 100, std::numeric_limits<float>::quiet_NaN(), -1, 0, infinity, -infinity};
    std::ranges::copy(values, depths.pixels().begin());
    const Plane<Rgb8> picture = picture_of_depths(depths);
    EXPECT_EQ(picture.at(0, 0), (Rgb8{253, 231, 37})) << "nearest is the bright end of viridis";
    EXPECT_EQ(picture.at(1, 0), (Rgb8{33, 145, 140})) << "half of the range by logarithm";
    EXPECT_EQ(picture.at(2, 0), (Rgb8{68, 1, 84}));
    for (const int x : {3, 4, 5, 7}) EXPECT_EQ(picture.at(x, 0), (Rgb8{255, 0, 255})) << x;
    EXPECT_LT(int(picture.at(6, 0).g), 40) << "background is dark";
}

TEST(Pictures, ADepthlessFrameIsNoReasonToFail) {
    const Plane<Rgb8> picture = picture_of_depths(Plane<float>({3, 2}, background_depth));
    EXPECT_EQ(std::ranges::count(picture.pixels(), picture.at(0, 0)), 6);
    EXPECT_NE(picture_of_depths(Plane<float>({1, 1}, 5.0f)).at(0, 0), picture.at(0, 0));
}

TEST(ClassStyle, ColoursAndGlyphsDiffer) {
    std::set<std::tuple<int, int, int>> colours;
    std::set<std::string_view> glyphs;
    for (int i = 0; i < pixel_class_count; ++i) {
        const ClassStyle& style = style_of(PixelClass(i));
        colours.insert({style.colour.r, style.colour.g, style.colour.b});
        glyphs.insert(style.glyph);
    }
    EXPECT_EQ(colours.size(), std::size_t(pixel_class_count));
    EXPECT_EQ(glyphs.size(), std::size_t(pixel_class_count));
}

}  // namespace zproof
