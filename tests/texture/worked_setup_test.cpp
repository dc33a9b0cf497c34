#include "tests/support/worked_setup.h"

#include <gtest/gtest.h>
#include <cstdio>

#include "texture/catalogue.h"

namespace zproof::texture {
namespace {

TEST(WorkedSetup, Explore) {
    const Homography<double> map = worked::texels_from_raster(0);
    for (const Method& method : methods()) {
        FilterOptions options;
        if (method.name.starts_with("supersample")) options.subdivisions = 8;
        const Sampler sampler = method.prepare(worked::checks(), options);
        double taps = 0;
        for (int y = 52; y < 256; ++y)
            for (int x = 0; x < 256; ++x) taps += double(sampler.taps(footprint(map, x, y, Derivatives::analytic)).size());
        printf("%-22s %8.4f %8.4f\n", method.name.c_str(), taps / 256 / 204, worked::psnr(0, [&](const Footprint& f) { return sampler.colour(f).r; }));
    }
}

}  // namespace
}  // namespace zproof::texture
