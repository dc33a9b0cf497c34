/// Views that are sampled beside their pixels' centres: what an honest renderer shows there passes, and what
/// belongs to another place does not.
#include <gtest/gtest.h>

#include "compare/diagnosis/diagnosis.h"
#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/standard_samples.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

View at(View view, const Sample& sample) {
    view.sample = sample;
    return view;
}

View at(const View& view, const glm::dvec2& offset_px) { return at(view, Sample{.offset_px = offset_px}); }

/// A suite scene's first view, and who may be asked about it.
class SampledScene {
  public:
    explicit SampledScene(const std::string& name, int width = 160, int height = 90)
        : loaded_(generate_suite_scene(name, width, height)), embree_(loaded_.scene) {}

    const View& view() const { return loaded_.views.front(); }
    Frame drawn(const View& view) const { return rasterizer::render(loaded_.scene, view); }
    Frame traced(const View& view) const { return embree_.trace(view); }

    Verdict verdict(const View& view, const Frame& frame, const Precision& precision) const {
        return judge(loaded_.scene, view, {frame, precision}, {traced(view), oracle::embree_precision()});
    }
    std::uint64_t defects(const View& view, const Frame& frame, const Precision& precision) const {
        return defect_count(verdict(view, frame, precision));
    }
    std::string cause(const View& view, const Frame& frame, const Precision& precision) const {
        const Frame reference = traced(view);
        const RenderedFrame ours{frame, precision}, theirs{reference, oracle::embree_precision()};
        const auto diagnosis =
            diagnose(loaded_.scene, view, ours, theirs, judge(loaded_.scene, view, ours, theirs));
        return diagnosis && diagnosis->cause ? diagnosis->cause->name : "";
    }

  private:
    Loaded loaded_;
    oracle::Embree embree_;
};

std::vector<Sample> all_standard_samples() {
    std::vector<Sample> all;
    for (const int count : {1, 2, 4, 8, 16})
        for (const Sample& sample : standard_samples(count)) all.push_back(sample);
    return all;
}

class EverySample : public testing::TestWithParam<std::string> {};

TEST_P(EverySample, OfTheRasterizerHasNoDefect) {
    const SampledScene scene(GetParam());
    for (const Sample& sample : all_standard_samples()) {
        SCOPED_TRACE(testing::Message() << sample.count << ":" << sample.index);
        const View view = at(scene.view(), sample);
        const Verdict verdict = scene.verdict(view, scene.drawn(view), rasterizer::precision());
        EXPECT_EQ(defect_count(verdict), 0u);
        EXPECT_EQ(verdict.reference_defects, 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Suite, EverySample,
                         testing::Values("room", "shared_edges", "off_axis", "orthographic", "oblique",
                                         "near_plane"),
                         [](const auto& scene) { return scene.param; });

/// Every pixel of a frame whose pixels are `scale` times as small, that holds the sample in its centre.
Frame picked(const Frame& fine, Resolution size, int scale, const glm::ivec2& first) {
    Frame frame(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            frame.primitive.at(x, y) = fine.primitive.at(scale * x + first.x, scale * y + first.y);
            frame.camera_depth.at(x, y) = fine.camera_depth.at(scale * x + first.x, scale * y + first.y);
        }
    return frame;
}

/// The samples of standard:4 are centres of pixels of a picture that is four times as wide and as high.
TEST(SampleOf4, IsTheCentreOfAPixelOfAFinerPicture) {
    for (const std::string name : {"room", "oblique"}) {
        const SampledScene scene(name);
        View fine = scene.view();
        fine.width *= 4, fine.height *= 4;
        const Frame traced = scene.traced(fine);
        for (const Sample& sample : standard_samples(4)) {
            SCOPED_TRACE(name + sample_word(sample));
            const glm::ivec2 first{glm::floor((sample.offset_px + 0.5) * 4.0)};
            const View view = at(scene.view(), sample);
            const Frame frame = picked(traced, {view.width, view.height}, 4, first);
            EXPECT_EQ(scene.defects(view, frame, oracle::embree_precision()), 0u);
            EXPECT_GT(scene.defects(scene.view(), frame, oracle::embree_precision()), 0u);
        }
    }
}

TEST(AnotherSample, HasDefectsAndIsCalledByItsName) {
    const SampledScene scene("room", 320, 180);
    const glm::dvec2 offset_px = standard_samples(4)[0].offset_px;
    const View view = at(scene.view(), offset_px);
    const auto cause_of = [&](const glm::dvec2& instead_px) {
        const Frame frame = scene.drawn(at(scene.view(), instead_px));
        EXPECT_GT(scene.defects(view, frame, rasterizer::precision()), 0u);
        return scene.cause(view, frame, rasterizer::precision());
    };
    EXPECT_EQ(cause_of({0, 0}), "pixels are sampled at their centres");
    EXPECT_EQ(cause_of({offset_px.x, -offset_px.y}), "the sample's y is up");
    EXPECT_EQ(cause_of({offset_px.y, offset_px.x}), "the sample's x and y are swapped");
}

TEST(AnotherSample, OfThePatternIsCalledByItsIndex) {
    const SampledScene scene("room", 320, 180);
    const std::vector<Sample> samples = standard_samples(4);
    const View view = at(scene.view(), samples[1]);
    const Frame frame = scene.drawn(at(scene.view(), samples[3]));
    EXPECT_EQ(scene.cause(view, frame, rasterizer::precision()), "it is sample 3");
}

/// A frame that is sampled d beside the sample needs an eps of d, and no less.
TEST(BoundAtASample, HoldsWhatIsMovedByItAndNothingMore) {
    const SampledScene scene("room", 320, 180);
    const double moved_px = 1.0 / 256;
    for (const Sample& sample : standard_samples(8)) {
        SCOPED_TRACE(sample_word(sample));
        const View view = at(scene.view(), sample);
        const Frame frame =
            scene.traced(at(scene.view(), sample.offset_px + glm::dvec2(moved_px, -moved_px)));
        const auto with_eps = [&](double eps_px) {
            return scene.defects(view, frame, BoundedPrecision{.eps_px = eps_px, .depth_relative = 2e-6});
        };
        EXPECT_EQ(with_eps(1.01 * moved_px), 0u);
        EXPECT_GT(with_eps(0.9 * moved_px), 0u);
    }
}

}  // namespace
}  // namespace zproof
