#include "filters/methods/recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/methods/catalogue.h"
#include "math/rounding.h"
#include "tests/support/footprints.h"
#include "tests/support/worked_setup.h"

namespace zproof::texture {
namespace {

constexpr BaseLevel square{64, 64, {}};

Kernel kernel_of(const char* method, const Footprint& footprint) {
    return record(find_method(method)->prepare(random_image(64, 64, 3), {}), footprint, square);
}

TEST(Recorder, BilinearsKernelIsFourTexels) {
    const Kernel kernel = kernel_of("bilinear", flat_footprint({10.75, 20.625}, {1, 0}, {0, 1}));
    EXPECT_EQ(kernel.first_column, 10);
    EXPECT_EQ(kernel.first_row, 20);
    ASSERT_EQ(kernel.width, 2);
    ASSERT_EQ(kernel.height, 2);
    EXPECT_EQ(kernel.weights, (std::vector<double>{0.75 * 0.875, 0.25 * 0.875, 0.75 * 0.125, 0.25 * 0.125}));
    const KernelShape shape = shape_of(kernel);
    EXPECT_EQ(shape.sum, 1);
    EXPECT_EQ(shape.centroid, glm::dvec2(10.75, 20.625));
    EXPECT_EQ(shape.covariance[0][0], 0.75 * 0.25);
    EXPECT_EQ(shape.covariance[1][1], 0.875 * 0.125);
    EXPECT_EQ(shape.covariance[0][1], 0);
    EXPECT_EQ(shape.negative_share, 0);
}

TEST(Recorder, TrilinearsKernelIsMadeOfBoxes) {
    // Steps of 2^1.5 texels: level 1 and 2 by halves, at the centre of a texel of level 2 at (22, 22).
    const double step = std::exp2(1.5);
    const Kernel kernel = kernel_of("trilinear-gl", flat_footprint({22, 22}, {step, 0}, {0, step}));
    // Level 2: texel [20, 24)^2. Level 1 meets four texels, the same 4 x 4 of level 0.
    EXPECT_EQ(kernel.first_column, 20);
    EXPECT_EQ(kernel.width, 4);
    EXPECT_EQ(kernel.height, 4);
    for (const double weight : kernel.weights) EXPECT_NEAR(weight, 1.0 / 16, 8 * unit_roundoff_float64);
    const Kernel aside = kernel_of("trilinear-gl", flat_footprint({23, 22}, {step, 0}, {0, step}));
    EXPECT_EQ(aside.first_column, 20);
    EXPECT_EQ(aside.width, 8);
    // Level 1's texels [20, 22), [22, 24) and [24, 26) lie 2, 0 and 2 texels away: it takes [22, 24) alone.
    const std::array row{
        0.75 / 32, 0.75 / 32, 0.75 / 32 + 1.0 / 16, 0.75 / 32 + 1.0 / 16, 0.25 / 32, 0.25 / 32,
        0.25 / 32, 0.25 / 32};
    for (int column = 20; column < 28; ++column)
        EXPECT_NEAR(aside.at(column, 22), row[std::size_t(column - 20)], 16 * unit_roundoff_float64)
            << column;
}

TEST(Recorder, SummedAreasKernelIsItsBox) {
    const Kernel kernel = kernel_of("sat-affine", flat_footprint({20.25, 30}, {8.5, 0}, {0, 4}));
    EXPECT_EQ(kernel.first_column, 16);
    EXPECT_EQ(kernel.first_row, 28);
    ASSERT_EQ(kernel.width, 9);  // 16 to 24.5
    ASSERT_EQ(kernel.height, 4);
    for (int row = 28; row < 32; ++row)
        for (int column = 16; column < 25; ++column)
            EXPECT_NEAR(kernel.at(column, row), (column == 24 ? 0.5 : 1) / 34, 64 * unit_roundoff_float64)
                << column;
}

TEST(Recorder, ABoxOfWholeTexelsHasAUniformBoxsVarianceLessATexels) {
    const KernelShape shape = shape_of(kernel_of("sat-moment", flat_footprint({20, 30}, {8, 0}, {0, 4})));
    EXPECT_NEAR(shape.covariance[0][0], (64 - 1) / 12.0, 1e3 * unit_roundoff_float64);
    EXPECT_NEAR(shape.covariance[1][1], (16 - 1) / 12.0, 1e3 * unit_roundoff_float64);
    EXPECT_NEAR(shape.centroid.x, 20, 1e3 * unit_roundoff_float64);
}

TEST(Recorder, UnwrapsARepeatedAxis) {
    const Kernel kernel = kernel_of("sat-affine", flat_footprint({-1, 66}, {8, 0}, {0, 6}));
    EXPECT_EQ(kernel.first_column, -5);
    EXPECT_EQ(kernel.width, 8);
    EXPECT_EQ(kernel.first_row, 63);
    EXPECT_EQ(kernel.height, 6);
    EXPECT_NEAR(shape_of(kernel).centroid.x, -1, 1e3 * unit_roundoff_float64);
    EXPECT_NEAR(shape_of(kernel).centroid.y, 66, 1e3 * unit_roundoff_float64);
}

TEST(Recorder, TellsTheShareOfNegativeWeight) {
    EXPECT_EQ(shape_of({0, 0, 3, 1, {0.5, -0.25, 0}}).negative_share, 1.0 / 3);
}

TEST(Recorder, LeavesAClampedAxisAlone) {
    const Addressing clamp{Wrap::clamp_to_edge, Wrap::clamp_to_edge};
    const Sampler sat = find_method("sat-affine")->prepare(random_image(64, 64, 3), {.addressing = clamp});
    const Kernel kernel = record(sat, flat_footprint({-1, 10}, {8, 0}, {0, 6}), {64, 64, clamp});
    EXPECT_EQ(kernel.first_column, 0);
    EXPECT_EQ(kernel.width, 3);
    EXPECT_NEAR(kernel.at(0, 10), 6 / 48.0,
                64 * unit_roundoff_float64);  // five texels beyond the edge and its own
    const Kernel beyond = record(sat, flat_footprint({-70, 10}, {8, 0}, {0, 6}), {64, 64, clamp});
    EXPECT_EQ(beyond.first_column, 0);
    EXPECT_EQ(beyond.width, 1);
}

class EveryKernel : public testing::TestWithParam<Method> {};

/// The recorder's kernel, applied to the texture, is what the method gives: for odd sizes and all wraps.
TEST_P(EveryKernel, TimesTheTextureIsTheColour) {
    const LinearImage image = random_image(37, 22, 3);
    const Homography<double> map = worked::texels_from_raster(35);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp_to_edge, Wrap::mirrored_repeat}) {
        const Addressing addressing{wrap, wrap};
        const Sampler sampler =
            GetParam().prepare(image, {.addressing = addressing, .sat_storage = SatStorage::integer});
        for (int y = 50; y < 256; y += 23) {
            const Footprint f = footprint(map, 7 * y % 256, y, Derivatives::analytic);
            const Kernel kernel = record(sampler, f, {37, 22, addressing});
            double sum = 0, weights = 0;
            for (int row = 0; row < kernel.height; ++row)
                for (int column = 0; column < kernel.width; ++column) {
                    const double weight = kernel.at(column + kernel.first_column, row + kernel.first_row);
                    sum += weight * image
                                        .at(wrapped(Wrap::repeat, column + kernel.first_column, 37),
                                            wrapped(Wrap::repeat, row + kernel.first_row, 22))
                                        .r;
                    weights += std::abs(weight);
                }
            // Levels of a chain are rounded to float32 once each, 6 of them; coordinates reach 10^4 texels.
            const double bound = weights * (6 * 0x1p-24 + 1e4 * 64 * unit_roundoff_float64);
            EXPECT_NEAR(sum, sampler.colour(f).r, bound) << "row " << y << ", wrap " << int(wrap);
            EXPECT_NEAR(shape_of(kernel).sum, 1, bound);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Recorder, EveryKernel, testing::ValuesIn(methods().begin(), methods().end()),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace zproof::texture
