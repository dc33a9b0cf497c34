// The standard patterns against Vulkan's table, and which offsets are samples at all.
#include "scenes/standard_samples.h"

#include <gtest/gtest.h>

#include <map>

#include "scenes/view.h"

namespace zproof {
namespace {

/// Vulkan 1.3, "Standard sample locations": from the pixel's upper left corner.
const std::map<int, std::vector<glm::dvec2>> vulkan{
    {1, {{0.5, 0.5}}},
    {2, {{0.75, 0.75}, {0.25, 0.25}}},
    {4, {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}},
    {8,
     {{0.5625, 0.3125},
      {0.4375, 0.6875},
      {0.8125, 0.5625},
      {0.3125, 0.1875},
      {0.1875, 0.8125},
      {0.0625, 0.4375},
      {0.6875, 0.9375},
      {0.9375, 0.0625}}},
    {16,
     {{0.5625, 0.5625},
      {0.4375, 0.3125},
      {0.3125, 0.625},
      {0.75, 0.4375},
      {0.1875, 0.375},
      {0.625, 0.8125},
      {0.8125, 0.6875},
      {0.6875, 0.1875},
      {0.375, 0.875},
      {0.5, 0.0625},
      {0.25, 0.125},
      {0.125, 0.75},
      {0.0, 0.5},
      {0.9375, 0.25},
      {0.875, 0.9375},
      {0.0625, 0.0}}}};

TEST(StandardSamples, LieWhereVulkanHasThem) {
    for (const auto& [count, places] : vulkan) {
        SCOPED_TRACE(count);
        const std::vector<Sample> samples = standard_samples(count);
        ASSERT_EQ(samples.size(), places.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            EXPECT_EQ(samples[i].index, int(i));
            EXPECT_EQ(samples[i].count, count);
            View view;
            view.sample = samples[i];
            EXPECT_EQ(sampled_at(view, 7, 3), places[i] + glm::dvec2(7, 3)) << i;
            EXPECT_TRUE(is_sample_offset(samples[i].offset_px)) << i;
        }
    }
}

TEST(StandardSamples, HaveNoOtherCount) {
    for (const int count : {-1, 0, 3, 5, 17, 32}) EXPECT_TRUE(standard_samples(count).empty()) << count;
}

TEST(SampleOffset, IsAMultipleOf1Over256InThePixel) {
    for (const double good : {-0.5, -1.0 / 256, 0.0, 127.0 / 256}) {
        EXPECT_TRUE(is_sample_offset({good, 0})) << good;
        EXPECT_TRUE(is_sample_offset({0, good})) << good;
    }
    for (const double bad : {-0.5 - 1.0 / 256, 0.5, 1.0 / 512, 0.1, double(NAN), double(INFINITY)}) {
        EXPECT_FALSE(is_sample_offset({bad, 0})) << bad;
        EXPECT_FALSE(is_sample_offset({0, bad})) << bad;
    }
}

TEST(SampleWord, NamesThePlaceInFull) {
    EXPECT_EQ(sample_word({}), "");
    EXPECT_EQ(sample_word({.offset_px = {-0.125, 127.0 / 256}}), "-0.125,0.49609375");
    EXPECT_EQ(sample_word(standard_samples(4)[2]), "standard:4:2");
    EXPECT_EQ(sample_word(standard_samples(1)[0]), "");
}

}  // namespace
}  // namespace zproof
