#include "worked_setup.h"

#include <gtest/gtest.h>
#include <cstdio>

#include "texture/catalogue.h"

namespace zproof::texture {
namespace {

TEST(WorkedSetup, Explore) {
    for (const Method& method : methods()) {
        FilterOptions options;
        if (method.name.starts_with("supersample")) options.subdivisions = 8;
        const Figures f = figures(method, options, 0);
        printf("%-22s %6.1f %6.2f\n", method.name.c_str(), f.texels_per_pixel, f.psnr_db);
    }
}

}  // namespace
}  // namespace zproof::texture
