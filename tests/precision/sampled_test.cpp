/// The presets at samples: a rasterizer that computes as they say has no defect at any standard sample.
#include <gtest/gtest.h>

#include "compare/judge.h"
#include "frame/precision_presets.h"
#include "oracle/embree.h"
#include "scenes/standard_samples.h"
#include "scenes/suite.h"
#include "tests/precision/emulated_rasterizer.h"

namespace zproof {
namespace {

/// Defects over the first views of a scene at the samples of a pattern, of one who draws other samples
/// instead.
class SampledSuite {
  public:
    explicit SampledSuite(const std::string& scene)
        : loaded_(generate_suite_scene(scene, 64, 36)), embree_(loaded_.scene) {}

    std::uint64_t defects(const RasterPrecision& precision, const Sample& judged, const Sample& drawn) const {
        View view = loaded_.views.front();
        view.sample = drawn;
        const Frame frame = emulate(precision, loaded_.scene, view);
        view.sample = judged;
        return defect_count(judge(loaded_.scene, view, {frame, precision},
                                  {embree_.trace(view), oracle::embree_precision()}));
    }

  private:
    Loaded loaded_;
    oracle::Embree embree_;
};

class EveryPreset : public testing::TestWithParam<std::string> {
  protected:
    RasterPrecision precision() const { return std::get<RasterPrecision>(*preset_precision(GetParam())); }
};

TEST_P(EveryPreset, HoldsAtEveryStandardSample) {
    for (const std::string name : {"shared_edges", "off_axis", "orthographic", "near_plane", "depth_range"}) {
        const SampledSuite scene(name);
        for (const int count : {4, 16})
            for (const Sample& sample : standard_samples(count))
                EXPECT_EQ(scene.defects(precision(), sample, sample), 0u)
                    << name << ' ' << sample_word(sample);
    }
}

TEST_P(EveryPreset, DoesNotHoldAtAnotherSample) {
    const SampledSuite scene("off_axis");
    const std::vector<Sample> samples = standard_samples(4);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_GT(scene.defects(precision(), samples[i], samples[(i + 1) % 4]), 0u) << i;
        EXPECT_GT(scene.defects(precision(), samples[i], Sample{}), 0u) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Presets, EveryPreset,
                         testing::Values("opengl", "opengl-24bit", "d3d11", "vulkan", "webgl", "pytorch3d"),
                         [](const auto& preset) {
                             std::string name = preset.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace zproof
