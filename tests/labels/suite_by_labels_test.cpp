/// The suite judged by depth alone and by materials: good frames pass, planted faults are found.
#include <gtest/gtest.h>

#include <algorithm>

#include "compare/judge.h"
#include "compare/labels/labelled_frame.h"
#include "oracle/embree.h"
#include "oracle/opengl.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

constexpr int width = 160, height = 90;

std::string in_words(const Verdict& verdict) {
    std::string text;
    for (int c = 0; c < pixel_class_count; ++c)
        text +=
            std::to_string(verdict.counts[std::size_t(c)]) + " " + std::string(name_of(PixelClass(c))) + " ";
    return text;
}

/// What the judge says of a frame of triangles once its ids are taken for labels only.
Verdict judged_by(const std::string& ids, const Loaded& loaded, const View& view,
                  const RenderedFrame& candidate, const RenderedFrame& reference) {
    const TriangleLabels labels = label_triangles(ids, loaded.scene);
    const Frame said = with_labels(candidate.frame, labels);
    const Frame frame = with_triangles(loaded.scene, view, {said, candidate.precision}, labels, reference);
    return judge(loaded.scene, view, {frame, candidate.precision}, reference);
}

class SuiteScene : public testing::TestWithParam<std::string> {
  protected:
    Loaded loaded = generate_suite_scene(GetParam(), width, height);
    oracle::Embree embree{loaded.scene};
};

TEST_P(SuiteScene, PassesByDepthAloneAndByMaterials) {
    const bool has_opengl = !oracle::opengl_is_missing();
    for (const View& view : loaded.views) {
        SCOPED_TRACE(view.name);
        const Frame rastered = rasterizer::render(loaded.scene, view), traced = embree.trace(view);
        const RenderedFrame ours{rastered, rasterizer::precision()},
            theirs{traced, oracle::embree_precision()};
        for (const char* ids : {"none", "material"}) {
            const Verdict rasterizer = judged_by(ids, loaded, view, ours, theirs),
                          ray_caster = judged_by(ids, loaded, view, theirs, ours);
            EXPECT_EQ(defect_count(rasterizer), 0u)
                << "rasterizer by " << ids << ": " << in_words(rasterizer);
            EXPECT_EQ(defect_count(ray_caster), 0u) << "Embree by " << ids << ": " << in_words(ray_caster);
            if (!has_opengl) continue;
            const Frame drawn = oracle::OpenGl(loaded.scene).render(view);
            const Verdict opengl =
                judged_by(ids, loaded, view, {drawn, oracle::OpenGlDriver().precision()}, theirs);
            EXPECT_EQ(defect_count(opengl), 0u) << "OpenGL by " << ids << ": " << in_words(opengl);
        }
    }
}

std::vector<std::string> suite_names() {
    std::vector<std::string> names;
    for (const SuiteEntry& entry : suite_manifest()) names.push_back(entry.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Suite, SuiteScene, testing::ValuesIn(suite_names()),
                         [](const auto& scene) { return scene.param; });

/// Frames of depth alone with a fault.
class FaultyDepths : public SuiteScene {
  protected:
    const View& view = loaded.views.front();
    Frame good = rasterizer::render(loaded.scene, view);

    std::uint64_t defects_of(const Frame& frame) const {
        const Frame reference = embree.trace(view);
        return defect_count(judged_by("none", loaded, view, {frame, rasterizer::precision()},
                                      {reference, oracle::embree_precision()}));
    }

    /// The triangle that most pixels see.
    std::uint32_t largest() const {
        std::vector<int> pixels(loaded.scene.triangles.size());
        for (const PrimitiveId id : good.primitive.pixels())
            if (id != PrimitiveId::none) ++pixels[std::size_t(id)];
        return std::uint32_t(std::ranges::max_element(pixels) - pixels.begin());
    }
};

TEST_P(FaultyDepths, AreFoundWhereTheFrameIsShifted) {
    Frame frame = good;
    for (int y = 0; y < height; ++y)
        for (int x = 1; x < width; ++x) frame.camera_depth.at(x, y) = good.camera_depth.at(x - 1, y);
    EXPECT_GT(defects_of(frame), 100u);
}

TEST_P(FaultyDepths, AreFoundWhereTheyAreTooLarge) {
    Frame frame = good;
    for (float& depth : frame.camera_depth.pixels()) depth *= 1.001f;
    EXPECT_GT(defects_of(frame), 1000u);
}

TEST_P(FaultyDepths, AreFoundWhereATriangleIsMissing) {
    Scene without = loaded.scene;
    glm::uvec3& triangle = without.triangles[largest()];
    triangle = glm::uvec3(triangle.x);
    EXPECT_GT(defects_of(rasterizer::render(without, view)), 0u);
}

INSTANTIATE_TEST_SUITE_P(Suite, FaultyDepths, testing::Values("room", "near_plane", "deep_overdraw"),
                         [](const auto& scene) { return scene.param; });

}  // namespace
}  // namespace zproof
