/// The interval that is shown of a pixel is the one that the pixel is judged by.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/commands/claim.h"
#include "filters/methods/catalogue.h"
#include "filters/selftest/filter_fault.h"
#include "tests/filters/limited_sampler.h"

namespace zproof::selftest {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

/// A picture of which every third pixel is wrong, some by little.
Picture mixed_picture(const FilterFixture& fixture, const std::string& method) {
    Picture picture = rasterizer::filtered(fixture.scene, fixture.view, fixture.frame,
                                           {.method = *texture::find_method(method)});
    for (std::size_t i = 0; i < picture.pixels().size(); i += 3)
        picture.pixels()[i].g += std::ldexp(1.0f, -int(i % 30));
    return picture;
}

bool is_inside(const Picture& picture, const PermittedInterval& interval, int x, int y) {
    return distance_outside(picture.at(x, y), interval.least.at(x, y), interval.greatest.at(x, y)) == 0;
}

class PermittedOf : public testing::TestWithParam<const char*> {
  protected:
    const FilterFixture fixture_ = filter_fixture(Ground::noise);
    const FilterClaim claim_{.method = GetParam(), .precision = gpu_with_exact_lod()};
    const Picture picture_ = mixed_picture(fixture_, GetParam());
    const PermittedInterval interval_ = permitted_by(claim_, picture_, fixture_.scene, fixture_.view);
};

TEST_P(PermittedOf, APixelHoldsItWhereTheCheckAdmitsThePixel) {
    const Conformance found = conformance_of(picture_, fixture_, claim_).found;
    ASSERT_GT(found.outside, 0u);
    ASSERT_LT(found.outside, found.judged);
    for (int y = 0; y < picture_.size().height; ++y)
        for (int x = 0; x < picture_.size().width; ++x)
            ASSERT_EQ(is_inside(picture_, interval_, x, y), found.slack.at(x, y) <= 1) << x << ", " << y;
}

/// The last float32 at either end is admissible by the check's own ranges, the next one is not.
TEST_P(PermittedOf, APixelEndsWhereTheRangeOfTheCheckEnds) {
    const ClaimedReference reference{fixture_.scene, fixture_.view, claim_};
    for (int y = 50; y < picture_.size().height; y += 7)
        for (int x = 3; x < picture_.size().width; x += 11) {
            const PermittedColours permitted = reference.at(x, y, claim_.precision);
            const ColourRange& nearest = nearest_range(picture_.at(x, y), permitted);
            const LinearRgb &least = interval_.least.at(x, y), &greatest = interval_.greatest.at(x, y);
            EXPECT_LE(slack_of(least, {nearest}), 1);
            EXPECT_LE(slack_of(greatest, {nearest}), 1);
            EXPECT_GT(slack_of({std::nextafter(least.r, -inf), least.g, least.b}, {nearest}), 1);
            EXPECT_GT(slack_of({greatest.r, greatest.g, std::nextafter(greatest.b, inf)}, {nearest}), 1);
        }
}

INSTANTIATE_TEST_SUITE_P(Methods, PermittedOf,
                         testing::Values("nearest", "trilinear-gl", "stochastic-bilinear"),
                         [](const auto& method) {
                             std::string name = method.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace zproof::selftest
