/// OpenGL before the judge: as the candidate over the whole suite, small, and as the oracle against our own.
#include "oracle/opengl.h"

#include <gtest/gtest.h>

#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "tests/gate/suite_verdict.h"

namespace zproof {
namespace {

class OpenGlOnSuite : public testing::TestWithParam<std::string> {};

TEST_P(OpenGlOnSuite, HasNoUnexplainedPixelAndKeepsItsDepthBounds) {
    const Loaded loaded = generate_suite_scene(GetParam(), 320, 180);
    const oracle::Embree embree(loaded.scene);
    const oracle::OpenGl opengl(loaded.scene);
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        const Frame frame = opengl.render(view);
        const Verdict verdict = judge(loaded.scene, view, {frame, oracle::OpenGlDriver().precision()},
                                      {embree.trace(view), oracle::embree_precision()});
        EXPECT_EQ(defect_count(verdict), 0u) << name_of(commonest_defect(verdict));
        EXPECT_EQ(verdict.reference_defects, 0u);
        EXPECT_LE(verdict.candidate_depth.max_error_over_bound, 1);
    }
}

std::vector<std::string> opengl_scene_names() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Suite, OpenGlOnSuite, testing::ValuesIn(opengl_scene_names()),
                         [](const auto& scene) { return scene.param; });

/// Pixels of a class over a suite scene's views, as the driver draws them, by this promise.
std::uint64_t pixels_of(PixelClass found, const std::string& scene, const Precision& promise) {
    const Loaded loaded = generate_suite_scene(scene, 320, 180);
    const oracle::Embree embree(loaded.scene);
    const oracle::OpenGl opengl(loaded.scene);
    std::uint64_t count = 0;
    for (const View& view : loaded.views)
        count += judge(loaded.scene, view, {opengl.render(view), promise},
                       {embree.trace(view), oracle::embree_precision()})
                     .counts[std::size_t(found)];
    return count;
}

TEST(OpenGlPromise, OfReversedZIsRedWhereTheDriverHasStandardZ) {
    auto promise = std::get<RasterPrecision>(oracle::OpenGlDriver().precision());
    const bool is_standard = promise.depth_buffer == DepthBuffer::standard_z;
    promise.depth_buffer = DepthBuffer::reversed_z;
    promise.clip_range = ClipRange::zero_to_one;
    promise.matrix_far = MatrixFar::infinite;
    EXPECT_EQ(pixels_of(PixelClass::wrong_depth, "depth_range", promise) > 0, is_standard);
}

class OpenGlAsOracle : public testing::TestWithParam<std::string> {};

TEST_P(OpenGlAsOracle, AgreesWithTheCorrectRasterizerAndFailsABrokenOne) {
    const Loaded loaded = generate_suite_scene(GetParam(), 320, 180);
    const View& view = loaded.views.front();
    const Frame oracle = oracle::OpenGl(loaded.scene).render(view);
    const auto defects_of = [&](const Frame& frame) {
        return defect_count(judge(loaded.scene, view, {frame, rasterizer::precision()},
                                  {oracle, oracle::OpenGlDriver().precision()}));
    };
    Frame frame = rasterizer::render(loaded.scene, view);
    EXPECT_EQ(defects_of(frame), 0u);
    frame.primitive.at(160, 120) = PrimitiveId::none;
    frame.camera_depth.at(160, 120) = background_depth;
    EXPECT_EQ(defects_of(frame), 1u);
}

INSTANTIATE_TEST_SUITE_P(Suite, OpenGlAsOracle, testing::Values("room", "deep_overdraw", "far_from_origin"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
