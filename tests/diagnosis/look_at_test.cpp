/// Every cause says where in a renderer's code to look first.
#include "compare/diagnosis/hypotheses/catalogue.h"

#include <gtest/gtest.h>

#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"

namespace zproof {
namespace {

std::vector<Hypothesis> hypotheses_about(const std::string& scene) {
    const Loaded loaded = generate_suite_scene(scene, 96, 54);
    const View& view = loaded.views.front();
    const Frame frame = rasterizer::render(loaded.scene, view);
    const RenderedFrame ours{frame, rasterizer::precision()}, theirs{frame, oracle::embree_precision()};
    return all_hypotheses({loaded.scene, view, ours, theirs});
}

TEST(LookAt, EveryHypothesisHasASentenceAndADescription) {
    for (const char* scene : {"room", "orthographic", "million_triangles"})
        for (const Hypothesis& h : hypotheses_about(scene)) {
            EXPECT_TRUE(h.cause.look_at.starts_with("Look ") && h.cause.look_at.ends_with("."))
                << h.cause.name;
            EXPECT_TRUE(h.cause.description.ends_with(".")) << h.cause.name;
        }
}

}  // namespace
}  // namespace zproof
