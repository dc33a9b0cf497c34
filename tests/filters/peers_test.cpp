/// What others' samplers do, each held against its own filter reference: OpenImageIO's TextureSystem and
/// OpenGL.
#include <gtest/gtest.h>

#include <iostream>

#include "filters/conformance/filter_precision_presets.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/reference/filter_peers.h"
#include "filters/selftest/filter_fault.h"

namespace zproof::selftest {
namespace {

using oracle::PeerFilter;

/// The filter reference of a method, declared the peer's precision.
ConformanceResult held(const Picture& picture, const FilterFixture& fixture, const char* method,
                       const FilterPrecision& precision, StepRule steps = StepRule::analytic) {
    oracle::FilterSettings settings;
    settings.kernel = oracle::filter_reference::ChainKernel::box;
    const oracle::FilterReference reference{fixture.scene, fixture.view,
                                            *oracle::find_filter_definition(method), settings, steps};
    const oracle::AdmissibleSurfaces surfaces{fixture.scene, fixture.view, precision};
    const PixelReference of_pixel = [&](int x, int y, const FilterPrecision& p) {
        return reference.at(x, y, surfaces.at(x, y), p);
    };
    ConformanceResult result{conformance(picture, of_pixel, precision), {}};
    result.rules = rules_at_fault(picture, result.found, of_pixel, precision);
    std::cout << method << ": " << in_words(result) << "; worst slack " << result.found.worst_slack << " at ("
              << result.found.worst.x << ", " << result.found.worst.y << "), mean width "
              << result.found.mean_width << "\n";
    for (const RuleRelaxation& rule : result.rules)
        std::cout << "    " << name_of(rule.rule) << " to " << rule.bits << " bits explains "
                  << rule.explained << ", width " << rule.permissive << "\n";
    return result;
}

TEST(OpenImageIoFilter, ConformsToItsOwnReference) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    const auto drawn = [&](PeerFilter filter) {
        return oracle::openimageio_filtered(fixture.scene, fixture.view, fixture.frame, filter, {});
    };
    const FilterPrecision precision = *preset_filter_precision("oiio");
    EXPECT_FALSE(held(drawn(PeerFilter::bilinear), fixture, "bilinear", precision).is_caught());
    EXPECT_FALSE(held(drawn(PeerFilter::trilinear), fixture, "trilinear-oiio", precision).is_caught());
    EXPECT_TRUE(held(drawn(PeerFilter::trilinear), fixture, "trilinear-gl", precision).is_caught());
    EXPECT_FALSE(held(drawn(PeerFilter::anisotropic), fixture, "aniso-oiio", precision).is_caught());
}

TEST(OpenGlFilter, IsComparedWithItsOwnReference) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    const auto drawn = [&](PeerFilter filter, StepRule steps) {
        return oracle::opengl_filtered(fixture.scene, fixture.view, fixture.frame, {filter, steps}, {});
    };
    const FilterPrecision precision = oracle::opengl_filter_precision();
    const StepRule exact = StepRule::analytic, quad = StepRule::quad_differences;
    EXPECT_FALSE(held(drawn(PeerFilter::bilinear, exact), fixture, "bilinear", precision).is_caught());
    EXPECT_FALSE(held(drawn(PeerFilter::trilinear, exact), fixture, "trilinear-mesa", precision).is_caught());
    EXPECT_TRUE(held(drawn(PeerFilter::trilinear, exact), fixture, "trilinear-gl", precision).is_caught());
    EXPECT_FALSE(
        held(drawn(PeerFilter::trilinear, quad), fixture, "trilinear-mesa", precision, quad).is_caught());
    // No filter reference of ours describes its anisotropic filter wholly (docs/filter-peers.md); lines of
    // taps do not at all.
    EXPECT_TRUE(
        held(drawn(PeerFilter::anisotropic, exact), fixture, "aniso-ext-linear", precision).is_caught());
}

TEST(VulkanFilter, KeepsWhatItsLimitsPromise) {
    const FilterFixture fixture = filter_fixture(Ground::noise);
    const StepRule exact = StepRule::analytic, quad = StepRule::quad_differences;
    const auto drawn = [&](PeerFilter filter, StepRule steps) {
        return oracle::vulkan_filtered(fixture.scene, fixture.view, fixture.frame, {filter, steps});
    };
    const Picture given = drawn(PeerFilter::trilinear, exact), own = drawn(PeerFilter::trilinear, quad);
    FilterPrecision promise = oracle::vulkan_filter_precision();
    EXPECT_FALSE(held(given, fixture, "trilinear-gl", promise).is_caught());
    EXPECT_FALSE(held(own, fixture, "trilinear-gl", promise, quad).is_caught());
    EXPECT_TRUE(held(given, fixture, "bilinear", promise).is_caught());
    // Steps that are given leave Vulkan's choice of LOD nothing to choose; those of a quad are other steps.
    promise.lod_below = promise.lod_above = 0;
    EXPECT_FALSE(held(given, fixture, "trilinear-gl", promise).is_caught());
    EXPECT_TRUE(held(own, fixture, "trilinear-gl", promise).is_caught());
    // Its anisotropic filter is no line of taps, and Vulkan names none (docs/vulkan.md).
    EXPECT_TRUE(
        held(drawn(PeerFilter::anisotropic, exact), fixture, "aniso-ext-linear", promise).is_caught());
}

}  // namespace
}  // namespace zproof::selftest
