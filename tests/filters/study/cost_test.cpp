#include "filters/study/cost.h"

#include <gtest/gtest.h>

#include "filters/methods/catalogue.h"

namespace zproof::study {
namespace {

/// A 64 x 64 texture of one material; a texel is 16 bytes, so 4 share a line.
SourceTextures one_texture() {
    SourceTexture source{{64, 64, std::vector<glm::vec4>(64 * 64, glm::vec4{0.5f})}, {}};
    return {source};
}

Lookup at(double u, double v) {
    texture::Footprint footprint;
    footprint.centre = {u, v};
    footprint.per_x = {1, 0};
    footprint.per_y = {0, 1};
    footprint.texels_from_raster = {{1, 0, u - 0.5}, {0, 1, v - 0.5}, {0, 0, 1}};
    footprint.centre_raster = {0.5, 0.5};
    return {0, footprint};
}

Cost cost(const char* method, const std::vector<Lookup>& lookups) {
    return cost_of({.method = *texture::find_method(method)}, one_texture(), lookups);
}

TEST(Cost, OfNearestIsOneTexelInOneLine) {
    const Cost found = cost("nearest", {at(3.5, 7.5), at(60, 60)});
    EXPECT_EQ(found.texels, 1);
    EXPECT_EQ(found.lines, 1);
    EXPECT_EQ(found.bytes_stored, 64u * 64 * 16);
    EXPECT_EQ(found.pixels, 2u);
}

/// Texels 2 and 3 of two rows lie in one line each; texels 3 and 4 in two.
TEST(Cost, OfBilinearCountsDistinctLines) {
    EXPECT_EQ(cost("bilinear", {at(3, 8)}).lines, 2);
    EXPECT_EQ(cost("bilinear", {at(4, 8)}).lines, 4);
    EXPECT_EQ(cost("bilinear", {at(3, 8), at(4, 8)}).lines, 3);
    EXPECT_EQ(cost("bilinear", {at(3, 8)}).texels, 4);
}

TEST(Cost, OfAMipChainIsAThirdMore) {
    const Cost found = cost("trilinear-gl", {at(3, 8)});
    EXPECT_EQ(found.bytes_stored, (64u * 64 + 32 * 32 + 16 * 16 + 8 * 8 + 4 * 4 + 2 * 2 + 1) * 16);
}

TEST(Cost, OfNoLookupIsNothingRead) {
    const Cost found = cost("bilinear", {});
    EXPECT_EQ(found.texels, 0);
    EXPECT_EQ(found.ns_per_sample, 0);
    EXPECT_EQ(found.bytes_stored, 64u * 64 * 16);
}

}  // namespace
}  // namespace zproof::study
