#include "reports/pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include "reports/class_colour.h"
#include "reports/depth_colours.h"
#include "reports/id_colours.h"

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

TEST(DepthColours, AreThoseOfTheFormulaAtEveryStepAndBetween) {
    for (const auto& [near, far] :
         {std::pair{1.0f, 100.0f}, {0.1f, 1e7f}, {5.0f, 5.00001f}, {1e-40f, 3e38f}}) {
        const auto low = std::bit_cast<std::uint32_t>(near), high = std::bit_cast<std::uint32_t>(far);
        const DepthColours colours({low, high});
        const std::uint32_t stride = std::max(1u, (high - low) / 300'000);
        for (std::uint32_t bits = low; bits <= high; bits += stride) {
            const auto depth = std::bit_cast<float>(bits);
            ASSERT_EQ(colours(depth), colours.by_formula(depth)) << depth << " of " << near << " to " << far;
            Rgb8 pixel;
            colours.colour({&depth, 1}, {&pixel, 1});
            ASSERT_EQ(pixel, colours(depth)) << depth << " of " << near << " to " << far;
        }
    }
}

TEST(DepthColours, RangeIsThatOfFinitePositiveDepths) {
    Plane<float> depths({100, 3}, -4.0f);
    for (int x = 0; x < 5; ++x)
        depths.at(20 * x, x % 3) =
            std::array{3.0f, std::numeric_limits<float>::infinity(), 0.0f,
                       std::numeric_limits<float>::quiet_NaN(), 1e-40f}[std::size_t(x)];
    EXPECT_EQ(range_of(depths).nearest, std::bit_cast<std::uint32_t>(1e-40f));
    EXPECT_EQ(range_of(depths).farthest, std::bit_cast<std::uint32_t>(3.0f));
    EXPECT_EQ(range_of(Plane<float>({9, 9}, background_depth)).farthest, 0u);
}

/// As a picture of ids had them before they were worked out side by side.
Rgb8 colour_of_id(std::uint32_t id) {
    std::uint32_t h = id + 1;
    h = (h ^ (h >> 16)) * 0x85EB'CA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2'AE35u;
    h = h ^ (h >> 16);
    const double hue = (h & 0xFFFF) / 65536.0, saturation = 0.35 + 0.3 * double(h >> 16 & 0xFF) / 255,
                 value = 0.6 + 0.38 * double(h >> 24) / 255;
    const auto one = [&](double shift) {
        const double turned = shift + 6 * hue, k = turned - (turned < 6 ? 0.0 : 6.0);
        const double light = value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
        return std::uint8_t(std::floor(255 * std::clamp(light, 0.0, 1.0) + 0.5));
    };
    return {one(5), one(3), one(1)};
}

TEST(Pictures, IdsAreColouredSideBySideAsOneByOne) {
    Plane<PrimitiveId> ids({1037, 301});
    for (std::size_t i = 0; i < ids.pixels().size(); ++i)
        ids.pixels()[i] = PrimitiveId(std::uint32_t(i % 3 ? i * 2654435761u : i));
    const Plane<Rgb8> picture = picture_of_ids(ids);
    for (std::size_t i = 0; i < ids.pixels().size(); ++i)
        ASSERT_EQ(picture.pixels()[i], colour_of_id(std::uint32_t(ids.pixels()[i]))) << i;
}

TEST(Pictures, NeighboursOfOneIdHaveItsColour) {
    Plane<PrimitiveId> ids({1037, 40});
    std::mt19937 random(11);
    std::uint32_t id = 0;
    for (PrimitiveId& pixel : ids.pixels()) {
        if (random() % 100 == 0)
            id = random() % 5 ? std::uint32_t(random()) : std::uint32_t(PrimitiveId::none);
        pixel = PrimitiveId(id);
    }
    const Plane<Rgb8> picture = picture_of_ids(ids);
    for (std::size_t i = 0; i < ids.pixels().size(); ++i) {
        const bool is_background = ids.pixels()[i] == PrimitiveId::none;
        ASSERT_EQ(picture.pixels()[i],
                  is_background ? background_colour : colour_of_id(std::uint32_t(ids.pixels()[i])))
            << i;
    }
}

/// Rows of several blocks, in which all colours and what is no depth stand beside depths of crowded steps.
TEST(Pictures, DepthsAreColouredSideBySideAsOneByOne) {
    Plane<float> depths({1037, 64});
    std::mt19937 random(3);
    for (float& depth : depths.pixels()) {
        const float magnitude = std::ldexp(1.0f, int(random() % 240) - 120);
        const float values[] = {magnitude, magnitude, -magnitude, background_depth, NAN, 0.0f};
        depth = values[random() % 6] * (1 + float(random() % 1000) / 1000);
    }
    const DepthColours colours(range_of(depths));
    const Plane<Rgb8> picture = picture_of_depths(depths);
    for (std::size_t i = 0; i < depths.pixels().size(); ++i) {
        const float depth = depths.pixels()[i];
        const Rgb8 expected = depth > 0 && std::isfinite(depth) ? colours.by_formula(depth)
                              : depth == background_depth       ? background_colour
                                                                : no_depth_colour;
        ASSERT_EQ(picture.pixels()[i], expected) << depth;
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

TEST(ClassFacts, ColoursAndGlyphsDiffer) {
    std::set<std::tuple<int, int, int>> colours;
    std::set<std::string_view> glyphs;
    for (int i = 0; i < pixel_class_count; ++i) {
        const Rgb8 colour = colour_of(PixelClass(i));
        colours.insert({colour.r, colour.g, colour.b});
        glyphs.insert(facts_of(PixelClass(i)).glyph);
    }
    EXPECT_EQ(colours.size(), std::size_t(pixel_class_count));
    EXPECT_EQ(glyphs.size(), std::size_t(pixel_class_count));
}

}  // namespace zproof
