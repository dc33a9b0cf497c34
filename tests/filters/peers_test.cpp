/// What others' samplers do, each held against its own law: OpenImageIO's TextureSystem and OpenGL.
#include <gtest/gtest.h>

#include <iostream>

#include "cli/selftest/filter_fault.h"
#include "oracle/peers/openimageio_filter.h"

namespace zproof::selftest {
namespace {

using oracle::PeerFilter;

/// The law of a method, declared the peer's precision.
FilterTrial held(const Picture& picture, const FilterStage& stage, const char* method,
                 const FilterPrecision& precision, StepRule steps = StepRule::analytic) {
    oracle::FilterSettings settings;
    settings.kernel = oracle::filter_law::ChainKernel::box;
    const oracle::FilterLaw law{stage.scene, stage.view, *oracle::find_filter_definition(method), settings,
                                steps};
    const PixelLaw of_pixel = [&](int x, int y, const FilterPrecision& p) {
        return law.at(x, y, stage.frame.primitive.at(x, y), p);
    };
    FilterTrial trial{conformance(picture, of_pixel, precision), {}};
    trial.rules = rules_at_fault(picture, trial.found, of_pixel, precision);
    std::cout << method << ": " << in_words(trial) << "; worst slack " << trial.found.worst_slack << " at ("
              << trial.found.worst.x << ", " << trial.found.worst.y << "), mean width "
              << trial.found.mean_width << "\n";
    for (const RuleTrial& rule : trial.rules)
        std::cout << "    " << name_of(rule.rule) << " to " << rule.bits << " bits explains "
                  << rule.explained << ", width " << rule.permissive << "\n";
    return trial;
}

TEST(OpenImageIoFilter, KeepsToItsOwnLaw) {
    const FilterStage stage = filter_stage(Ground::noise);
    const auto drawn = [&](PeerFilter filter) {
        return oracle::openimageio_filtered(stage.scene, stage.view, stage.frame, filter, {});
    };
    const FilterPrecision precision = oracle::openimageio_filter_precision();
    EXPECT_FALSE(held(drawn(PeerFilter::bilinear), stage, "bilinear", precision).is_caught());
    EXPECT_FALSE(held(drawn(PeerFilter::trilinear), stage, "trilinear-oiio", precision).is_caught());
    EXPECT_TRUE(held(drawn(PeerFilter::trilinear), stage, "trilinear-gl", precision).is_caught());
    EXPECT_FALSE(held(drawn(PeerFilter::anisotropic), stage, "aniso-oiio", precision).is_caught());
}

TEST(OpenGlFilter, IsHeldAgainstItsOwnLaw) {
    const FilterStage stage = filter_stage(Ground::noise);
    const auto drawn = [&](PeerFilter filter, StepRule steps) {
        return oracle::opengl_filtered(stage.scene, stage.view, stage.frame, {filter, steps}, {});
    };
    const FilterPrecision precision = oracle::opengl_filter_precision();
    const StepRule exact = StepRule::analytic, quad = StepRule::quad_differences;
    EXPECT_FALSE(held(drawn(PeerFilter::bilinear, exact), stage, "bilinear", precision).is_caught());
    EXPECT_FALSE(held(drawn(PeerFilter::trilinear, exact), stage, "trilinear-mesa", precision).is_caught());
    EXPECT_TRUE(held(drawn(PeerFilter::trilinear, exact), stage, "trilinear-gl", precision).is_caught());
    EXPECT_FALSE(
        held(drawn(PeerFilter::trilinear, quad), stage, "trilinear-mesa", precision, quad).is_caught());
    // No law of ours describes its anisotropic filter wholly (docs/filter-peers.md); lines of taps do not at
    // all.
    EXPECT_TRUE(held(drawn(PeerFilter::anisotropic, exact), stage, "aniso-ext", precision).is_caught());
}

}  // namespace
}  // namespace zproof::selftest
