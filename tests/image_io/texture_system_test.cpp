// What OpenImageIO's stochastic lookups are on the average.
#include "image_io/texture_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/frame/scratch_folder.h"

namespace zproof::image_io {
namespace {

constexpr int side = 64, draws = 1024;

class StochasticLookups : public ScratchFolder {
  protected:
    StochasticLookups() {
        std::mt19937 random(1);
        std::vector<float> rgb(std::size_t{3} * side * side);
        for (float& value : rgb) value = float(random() >> 8) * 0x1p-24f;
        system_.add({side, side}, rgb);
    }

    float red(TextureLookup lookup, float random) const {
        lookup.random = random;
        return system_.look_up(lookup)[0];
    }

    /// Over random numbers that are spread evenly.
    double mean_red(const TextureLookup& lookup) const {
        double sum = 0;
        for (int i = 0; i < draws; ++i) sum += double(red(lookup, (float(i) + 0.5f) / draws));
        return sum / draws;
    }

  private:
    TextureSystem system_{file(".")};
};

TextureLookup lookup_at(int i, MipMode mode) {
    const float s = 0.137f * float(i), width = 0.02f + 0.003f * float(i % 7);
    return {.mip = mode,
            .s = s,
            .t = 0.41f + s * s,
            .ds_per_x = width,
            .dt_per_x = width / 3,
            .ds_per_y = -width / 4,
            .dt_per_y = mode == MipMode::anisotropic ? 4 * width : width};
}

/// One threshold parts the numbers: the mean of evenly spread ones is off by at most the share of one.
TEST_F(StochasticLookups, OfTrilinearAreTrilinearOnTheAverage) {
    for (int i = 0; i < 40; ++i) {
        const TextureLookup lookup = lookup_at(i, MipMode::trilinear);
        EXPECT_NEAR(mean_red(lookup), double(red(lookup, -1)), 1.0 / draws) << i;
        EXPECT_NE(red(lookup, 0.01f), red(lookup, 0.99f)) << i;
    }
}

/// Its line of probes is weighted, and it draws them evenly: the average is another filter.
TEST_F(StochasticLookups, OfAnisotropicAreNotAnisotropicOnTheAverage) {
    double most = 0;
    for (int i = 0; i < 40; ++i) {
        const TextureLookup lookup = lookup_at(i, MipMode::anisotropic);
        most = std::max(most, std::abs(mean_red(lookup) - double(red(lookup, -1))));
    }
    EXPECT_GT(most, 0.01);
}

}  // namespace
}  // namespace zproof::image_io
