#include "filters/stored/summed_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "filters/methods/catalogue.h"
#include "math/rounding.h"
#include "tests/support/footprints.h"
#include "tests/support/worked_setup.h"
#include "texture/texels.h"

namespace zproof::texture {
namespace {

constexpr std::array storages{SatStorage::integer, SatStorage::float64, SatStorage::float32,
                              SatStorage::float32_less_mean};

/// Decoded from random 8-bit codes.
LinearImage noise(int width, int height, std::uint32_t seed = 7) {
    std::mt19937 rng(seed);
    LinearImage image{width, height, {}};
    const auto value = [&] { return float(linear_from_srgb(std::uint8_t(rng()))); };
    for (int i = 0; i < width * height; ++i) {
        const float red = value(), green = value(), blue = value();
        image.texels.emplace_back(red, green, blue, value());
    }
    return image;
}

TEST(SummedArea, EveryTexelOf8BitsIsAWholeNumberOfUnits) {
    for (int code = 0; code < 256; ++code) {
        const std::vector<float> values{float(linear_from_srgb(std::uint8_t(code))), float(code / 255.0)};
        for (const float value : values) {
            const double units = double(value) / SummedArea::unit;
            EXPECT_EQ(units, std::floor(units)) << code;
        }
    }
}

TEST(SummedArea, SumsOfIntegersAreExact) {
    const LinearImage image = noise(67, 41);
    const SummedArea table(image, SatStorage::integer);
    std::mt19937 rng(3);
    for (int trial = 0; trial < 2000; ++trial) {
        const int left = int(rng() % 67), top = int(rng() % 41),
                  right = left + 1 + int(rng() % std::uint32_t(67 - left)),
                  bottom = top + 1 + int(rng() % std::uint32_t(41 - top));
        glm::dvec4 expected{0};  // exact: fewer than 2^53 units
        for (int row = top; row < bottom; ++row)
            for (int column = left; column < right; ++column) expected += glm::dvec4(image.at(column, row));
        ASSERT_EQ(table.sum({left, right, 1}, {top, bottom, 1}), expected);
    }
}

TEST(SummedArea, OfLightThatSumsTo2ToThe28IsKeptAsIntegersAlone) {
    LinearImage image{2, 1, std::vector<glm::vec4>(2, glm::vec4(0x1p27f, 0, 0, 1))};
    EXPECT_THROW(SummedArea(image, SatStorage::float64), std::runtime_error);
    EXPECT_NO_THROW(SummedArea(image, SatStorage::integer));
    image.at(1, 0).x = std::nextafter(0x1p27f, 0.0f);
    const SummedArea table(image, SatStorage::float64);
    EXPECT_EQ(table.sum({0, 1, 1}, {0, 1, 1}).x, 0x1p27);
}

TEST(SummedArea, IntegersMayWrapRoundAndBeNegative) {
    // 2^27 twice over: sums from the third texel on no longer fit, differences do.
    LinearImage image{5, 1, std::vector<glm::vec4>(5, glm::vec4(0x1p27f, -0x1p27f, 1, -0.25f))};
    image.at(2, 0).x = 3;
    const SummedArea table(image, SatStorage::integer);
    EXPECT_EQ(table.sum({2, 4, 1}, {0, 1, 1}), glm::dvec4(0x1p27 + 3, -0x1p28, 2, -0.5));
    EXPECT_EQ(table.sum({4, 5, 1}, {0, 1, 1}), glm::dvec4(0x1p27, -0x1p27, 1, -0.25));
}

TEST(SummedArea, RoundsToItsStorageOnce) {
    const LinearImage image = noise(90, 70);
    const SummedArea exact(image, SatStorage::integer), wide(image, SatStorage::float64),
        narrow(image, SatStorage::float32);
    for (int row = 0; row < 70; row += 3)
        for (int column = 0; column < 90; column += 7) {
            EXPECT_EQ(wide.stored(column, row), exact.stored(column, row));  // below 2^53 units
            EXPECT_EQ(narrow.stored(column, row), glm::dvec4(glm::vec4(exact.stored(column, row))));
        }
    EXPECT_EQ(exact.bytes_per_texel(), 32u);
    EXPECT_EQ(narrow.bytes_per_texel(), 16u);
}

/// sum |weight| of a mean is 1, and each term has at most 8 roundings; the sum of up to 25 terms has 25 more.
constexpr double mean_bound = 40 * unit_roundoff_float64;

TEST(SatMethods, OverOneTexelAreBilinear) {
    const LinearImage image = noise(16, 9);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
        const FilterOptions options{
            .addressing = {wrap, wrap}, .sat_storage = SatStorage::integer, .subdivisions = 1};
        const Sampler bilinear = find_method("bilinear")->prepare(image, options);
        for (const Method& method : methods()) {
            if (!method.name.starts_with("sat-")) continue;
            const Sampler sat = method.prepare(image, options);
            for (double x = -3.5; x < 20; x += 0.37) {
                const Footprint small = flat_footprint({x, 0.61 * x}, {0.3, 0.1}, {-0.1, 0.3});
                const glm::dvec4 difference = glm::abs(sat.colour(small) - bilinear.colour(small));
                // The places themselves are rounded: 2^-53 times 20 texels, times the steepest slope, 1.
                for (int c = 0; c < 4; ++c)
                    EXPECT_LE(difference[c], mean_bound + 80 * unit_roundoff_float64) << method.name;
            }
        }
    }
}

TEST(SatMethods, GiveTheMeanOfTheWrappedTextureOverTheirBox) {
    const LinearImage image = noise(8, 5);
    std::mt19937 rng(11);
    std::uniform_real_distribution<double> place(-20, 20), size(1, 30);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
        const Sampler sat =
            find_method("sat-affine")
                ->prepare(image, {.addressing = {wrap, wrap}, .sat_storage = SatStorage::integer});
        for (int trial = 0; trial < 200; ++trial) {
            const glm::dvec2 centre{place(rng), place(rng)}, extent{size(rng), size(rng)};
            const glm::dvec2 low = centre - extent / 2.0, high = centre + extent / 2.0;
            double expected = 0;
            for (double row = std::floor(low.y); row < high.y; ++row)
                for (double column = std::floor(low.x); column < high.x; ++column)
                    expected +=
                        (std::min(high.x, column + 1) - std::max(low.x, column)) *
                        (std::min(high.y, row + 1) - std::max(low.y, row)) *
                        image.at(wrapped(wrap, std::int64_t(column), 8), wrapped(wrap, std::int64_t(row), 5))
                            .r;
            expected /= extent.x * extent.y;
            const double found = sat.colour(flat_footprint(centre, {extent.x, 0}, {0, extent.y})).r;
            // 32 x 32 terms of the definition, each rounded; places up to 64 over lengths of at least 1.
            EXPECT_NEAR(found, expected, (1024 + 4 * 64) * unit_roundoff_float64);
        }
    }
}

TEST(SatMethods, TapsTimesStoredSumsAreTheColour) {
    const LinearImage image = noise(21, 13);
    const Homography<double> map = worked::texels_from_raster(30);
    for (const Method& method : methods()) {
        if (!method.name.starts_with("sat-")) continue;
        const Sampler sat = method.prepare(image, {.sat_storage = SatStorage::float64});
        const SummedArea table(image, SatStorage::float64);
        for (int y = worked::first_row; y < worked::side; y += 9) {
            const Footprint f = footprint(map, 3 * y % worked::side, y, Derivatives::analytic);
            glm::dvec4 sum{0};
            double absolute = 0;
            for (const Tap& tap : sat.taps(f)) {
                sum += tap.weight * table.stored(tap.column, tap.row);
                absolute += std::abs(tap.weight) * 21 * 13;
            }
            // Coordinates reach 15000 texels; the weights of either sign inherit their rounding.
            const double bound = 64 * unit_roundoff_float64 * (absolute + 15000);
            EXPECT_LE(glm::length(sum - sat.colour(f)), bound) << method.name << " row " << y;
        }
    }
}

TEST(SatMethods, ShareOneConstant) {
    LinearImage image{33, 17, std::vector<glm::vec4>(33 * 17, glm::vec4(0.25f, 0.5f, 1, 1))};
    const Homography<double> map = worked::texels_from_raster(75);
    for (const Method& method : methods()) {
        if (!method.name.starts_with("sat-")) continue;
        for (const SatStorage storage : storages) {
            const Sampler sat = method.prepare(image, {.sat_storage = storage});
            for (int y = 0; y < worked::side; y += 5) {
                const Footprint f = footprint(map, 128, y, Derivatives::analytic);
                const glm::dvec4 colour = sat.colour(f);
                const double far = 1 + std::abs(f.centre.x) + std::abs(f.centre.y) + glm::length(f.per_y);
                for (int c = 0; c < 4; ++c)
                    EXPECT_NEAR(colour[c], double(image.texels[0][c]), 64 * far * unit_roundoff_float64)
                        << method.name << y;
            }
        }
    }
}

/// The reference's figures, to the tenth of a decibel that they are given with (docs/texture-filters.md).
TEST(SatMethods, ReproduceTheWorkedSetUp) {
    const std::array<std::pair<const char*, double>, 4> figures{
        {{"sat-affine", 26.35}, {"sat-area", 23.83}, {"sat-moment", 27.06}, {"sat-strips", 39.52}}};
    for (const auto& [name, decibels] : figures) {
        const Sampler sat =
            find_method(name)->prepare(worked::checks(), {.sat_storage = SatStorage::integer});
        EXPECT_NEAR(worked::psnr(0, [&](const Footprint& f) { return sat.colour(f).r; }), decibels, 0.05)
            << name;
    }
}

TEST(SatMethods, CutThePixelOnlyBeforeTheHorizon) {
    const LinearImage image = noise(64, 64);
    const Homography<double> map = worked::texels_from_raster(0);
    const double horizon = -map.w.c / map.w.b;  // w = 0 on this row
    const int row = int(std::floor(horizon));
    for (const char* name : {"sat-quad", "sat-subquads", "sat-strips"}) {
        const Footprint f = footprint(map, 100, row, Derivatives::analytic);
        const glm::dvec4 expected = find_method("sat-affine")->prepare(image, {}).colour(f);
        EXPECT_EQ(find_method(name)->prepare(image, {}).colour(f), expected) << name;
    }
}

/// What a storage loses, in 8-bit steps: root mean square and largest error of every box of one texel.
struct Loss {
    double rms = 0, largest = 0;
};
Loss loss(const LinearImage& image, SatStorage storage) {
    const SummedArea table(image, storage);
    Loss loss;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const double error =
                255 * (table.sum({column, column + 1, 1}, {row, row + 1, 1}).r - image.at(column, row).r);
            loss.rms += error * error / (double(image.width) * image.height);
            loss.largest = std::max(loss.largest, std::abs(error));
        }
    loss.rms = std::sqrt(loss.rms);
    return loss;
}

/// Four sums of up to sum() are rounded to 24 bits and subtracted: each errs by at most 2^-24 of itself.
TEST(SummedArea, LosesAtMostWhatItsStorageMust) {
    double before = 0;
    for (const int side : {64, 128, 256, 512}) {
        const LinearImage image = noise(side, side);
        const SummedArea table(image, SatStorage::integer);
        const double total = table.stored(side - 1, side - 1).r;
        const Loss narrow = loss(image, SatStorage::float32);
        EXPECT_LE(narrow.largest, 255 * 4 * 0x1p-24 * total);
        EXPECT_GT(narrow.rms, 3 * before);  // four times the texels, four times the sums
        EXPECT_LT(loss(image, SatStorage::float32_less_mean).rms, narrow.rms / 4);
        EXPECT_EQ(loss(image, SatStorage::float64).largest, 0);
        EXPECT_EQ(loss(image, SatStorage::integer).largest, 0);
        before = narrow.rms;
    }
}

}  // namespace
}  // namespace zproof::texture
