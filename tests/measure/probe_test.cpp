#include "measure/probe.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "subjects.h"

namespace zproof::measure {
namespace {

/// A renderer that draws nothing and counts its pictures.
struct Blind {
    int pictures = 0;
    Renderer renderer() {
        return {.name = "blind",
                .render =
                    [this](const Scene&, const View& view) {
                        ++pictures;
                        return Frame({view.width, view.height});
                    },
                .declared = rasterizer::precision()};
    }
};

/// Answers by the number that it was drawn with, not by the picture.
Probe probe_at(float threshold, float low, float high, float& drawn) {
    return {.low = low,
            .high = high,
            .draw = [&drawn](Scene&, float value) { drawn = value; },
            .answer = [&drawn, threshold](const Frame&) { return drawn <= threshold; }};
}

TEST(Bisect, EndsAtNeighbouringFloats) {
    for (const float threshold : {1.0f, 0.1f, -3.5f, 0.0f, 1e-30f}) {
        Blind blind;
        float drawn = 0;
        const Flip flip =
            bisect(blind.renderer(), raster_view(1, 1), {probe_at(threshold, -4, 4, drawn)}).front();
        EXPECT_EQ(flip.low, threshold);
        EXPECT_EQ(flip.high, std::nextafter(threshold, 9.0f));
        EXPECT_LE(blind.pictures, 2 + 32);
    }
}

TEST(Bisect, TakesTogetherWhatCanBeSeenInOnePicture) {
    Blind blind;
    float first = 0, second = 0;
    const auto flips = bisect(blind.renderer(), raster_view(1, 1),
                              {probe_at(1.25f, 1, 2, first), probe_at(1e-5f, -1000, 1000, second)});
    EXPECT_EQ(flips[0].low, 1.25f);
    EXPECT_EQ(flips[1].low, 1e-5f);
    EXPECT_LE(blind.pictures, 2 + 32);
}

TEST(Bisect, RefusesAnAnswerThatDoesNotTurn) {
    Blind blind;
    float drawn = 0;
    EXPECT_THROW(bisect(blind.renderer(), raster_view(1, 1), {probe_at(9, 0, 1, drawn)}), Unmeasurable);
    EXPECT_THROW(bisect(blind.renderer(), raster_view(1, 1), {probe_at(-9, 0, 1, drawn)}), Unmeasurable);
}

/// Lanes that answer alike.
std::vector<Probe> lanes_at(float threshold, float low, float high, std::array<float, 64>& drawn) {
    std::vector<Probe> lanes;
    for (float& of_lane : drawn) lanes.push_back(probe_at(threshold, low, high, of_lane));
    return lanes;
}

TEST(BisectInLanes, EndsAtNeighbouringFloatsAfterSixPictures) {
    for (const float threshold : {1.0f, 0.1f, -3.5f, 0.0f, 1e-30f, -4.0f, 3.9999998f}) {
        Blind blind;
        std::array<float, 64> drawn{};
        const Flip flip =
            bisect_in_lanes(blind.renderer(), raster_view(1, 1), lanes_at(threshold, -4, 4, drawn));
        EXPECT_EQ(flip.low, threshold);
        EXPECT_EQ(flip.high, std::nextafter(threshold, 9.0f));
        EXPECT_LE(blind.pictures, 6);
    }
}

/// Each lane turns at a place of its own: the ends are two that lanes said, and neighbours.
TEST(BisectInLanes, EndsWhereTheLanesDiffer) {
    for (int widest = 1; widest < 200; widest += 3) {
        Blind blind;
        std::array<float, 64> drawn{};
        std::vector<Probe> lanes;
        for (std::size_t i = 0; i < drawn.size(); ++i)
            lanes.push_back(probe_at(1 + float(int(i) * 7919 % widest) * 0x1p-23f, 1,
                                     1 + float(widest) * 0x1p-23f, drawn[i]));
        const Flip flip = bisect_in_lanes(blind.renderer(), raster_view(1, 1), lanes);
        EXPECT_EQ(flip.high, std::nextafter(flip.low, 9.0f));
        EXPECT_GE(flip.low, 1.0f);
        EXPECT_LT(flip.low, 1.0f + float(widest) * 0x1p-23f);
        EXPECT_LE(blind.pictures, 2);
    }
}

TEST(BisectInLanes, RefusesAnAnswerThatDoesNotTurn) {
    Blind blind;
    std::array<float, 64> drawn{};
    for (const float threshold : {9.0f, -9.0f})
        EXPECT_THROW(bisect_in_lanes(blind.renderer(), raster_view(1, 1), lanes_at(threshold, 0, 1, drawn)),
                     Unmeasurable);
}

TEST(SimplestIn, HasTheFewestBinaryPlaces) {
    EXPECT_EQ(simplest_in({0.4999, 0.5002}), 0.5);
    EXPECT_EQ(simplest_in({-0.001, 0.001}), 0);
    EXPECT_EQ(simplest_in({0.3, 0.4}), 0.375);
    EXPECT_EQ(simplest_in({0.25, 0.26}), 0.25);
}

}  // namespace
}  // namespace zproof::measure
