// Filters that look up a table, held to what a graphics card promises.
#include <gtest/gtest.h>

#include <algorithm>

#include "filters/conformance/filter_precision_presets.h"
#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"
#include "tests/filters/limited_sampler.h"
#include "tests/filters/near_ground.h"

namespace zproof {
namespace {

class FilterOfATable : public testing::TestWithParam<const char*> {
  protected:
    Conformance held(const selftest::FilterFixture& fixture, const FilterPrecision& promise,
                     float gain) const {
        Picture picture = rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                               {.method = *texture::find_method(GetParam()), .options = {}});
        for (LinearRgb& pixel : picture.pixels()) pixel = {gain * pixel.r, gain * pixel.g, gain * pixel.b};
        return selftest::conformance_of(picture, fixture, {.method = GetParam(), .precision = promise}).found;
    }
};

/// Its LOD is free by one and a half levels: each entry that this leaves open is asked, and no pixel is given
/// up.
TEST_P(FilterOfATable, IsDecidedUnderTheWholePromise) {
    const Conformance found = held(near_ground(), *preset_filter_precision("gpu"), 1);
    EXPECT_EQ(found.outside, 0u);
    EXPECT_EQ(found.anything, 0u);
}

/// Weights that are off still have the sum 1: one colour stays what it is.
TEST_P(FilterOfATable, IsNotAThousandthBrighterOnOneColour) {
    selftest::FilterFixture fixture = near_ground();
    std::ranges::fill(fixture.scene.images.at(0).texels, std::uint8_t{200});
    const FilterPrecision promise = gpu_with_exact_lod();
    EXPECT_EQ(held(fixture, promise, 1).outside, 0u);
    const auto textured = std::ranges::count_if(fixture.frame.primitive.pixels(),
                                                [](PrimitiveId id) { return id != PrimitiveId::none; });
    EXPECT_EQ(held(fixture, promise, 1.001f).outside, std::uint64_t(textured));
}

INSTANTIATE_TEST_SUITE_P(Methods, FilterOfATable,
                         testing::Values("cardinality-4", "cardinality-8", "bilinear-reads-2"));

}  // namespace
}  // namespace zproof
