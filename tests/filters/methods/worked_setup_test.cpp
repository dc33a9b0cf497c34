// The reference's worked set-up (../shared/reference/texture-filters.md, section 7): a chequered plane seen
// to the horizon. Its figures are printed to 0.01 dB and 0.1 texels.
#include "tests/support/worked_setup.h"

#include <gtest/gtest.h>

#include "filters/methods/catalogue.h"

namespace zproof::texture {
namespace {

struct Figure {
    const char* method;
    double psnr_db, texels_per_pixel;
};

/// Printed for box mip chains, anisotropy 16, 8 x 8 supersamples.
constexpr Figure printed[] = {
    {"nearest", 13.88, 1.0},         {"bilinear", 14.82, 4.0},
    {"trilinear-gl", 22.82, 7.4},    {"trilinear-area", 21.65, 7.1},
    {"ripmap", 26.82, 16.0},         {"aniso-ext-linear", 33.54, 31.7},
    {"aniso-midpoint", 40.50, 31.7}, {"aniso-d3d11", 40.97, 33.3},
    {"ewa-pbrt", 28.28, 40.2},       {"supersample-nearest", 32.08, 64.0},
};

/// The printed counts of reads include four rows more than the printed errors: rows 52 to 255, found by
/// trying.
double texels_per_pixel(const Sampler& sampler) {
    const Homography<double> map = worked::texels_from_raster(0);
    constexpr int first_row = 52;
    double reads = 0;
    for (int y = first_row; y < worked::side; ++y)
        for (int x = 0; x < worked::side; ++x)
            reads += double(sampler.taps(footprint(map, x, y, Derivatives::analytic)).size());
    return reads / (worked::side * (worked::side - first_row));
}

class WorkedSetup : public testing::TestWithParam<Figure> {};

TEST_P(WorkedSetup, GivesThePrintedFigures) {
    const Sampler sampler =
        find_method(GetParam().method)
            ->prepare(worked::checks(),
                      {.mip_kernel = MipKernel::box, .max_anisotropy = 16, .subdivisions = 8});
    EXPECT_NEAR(worked::psnr(0, [&](const Footprint& f) { return sampler.colour(f).r; }), GetParam().psnr_db,
                0.01);
    EXPECT_NEAR(texels_per_pixel(sampler), GetParam().texels_per_pixel, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Reference, WorkedSetup, testing::ValuesIn(printed), [](const auto& test) {
    std::string name = test.param.method;
    std::ranges::replace(name, '-', '_');
    return name;
});

/// Lines of taps on the plane turned by phi, as an independent implementation has them; its taps are linear.
struct TurnedFigure {
    const char* method;
    double phi_degrees, psnr_db;
};
constexpr TurnedFigure turned[] = {
    {"aniso-ext-linear", 22.5, 33.21},  {"aniso-ext-linear", 45, 33.07},
    {"aniso-vulkan-linear", 0, 34.19},  {"aniso-vulkan-linear", 22.5, 33.68},
    {"aniso-vulkan-linear", 45, 33.50},
};

TEST(TurnedSetup, GivesTheFiguresOfLinesOfTaps) {
    for (const TurnedFigure& figure : turned) {
        const Sampler sampler =
            find_method(figure.method)->prepare(worked::checks(), {.mip_kernel = MipKernel::box});
        EXPECT_NEAR(worked::psnr(figure.phi_degrees, [&](const Footprint& f) { return sampler.colour(f).r; }),
                    figure.psnr_db, 0.01)
            << figure.method << ", " << figure.phi_degrees;
    }
}

}  // namespace
}  // namespace zproof::texture
