#include <gtest/gtest.h>

#include <algorithm>

#include "lessons/cost/study.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "scenes/suite/mesh_builder.h"
#include "scenes/suite/shapes.h"
#include "scenes/suite/views.h"

namespace zproof::study::cost {
namespace {

/// Each experiment varies one of the lecture's quantities and keeps the others, or all but the triangles of a
/// layer.
TEST(CostExperiments, VaryOneThingAtATime) {
    for (const Experiment& experiment : experiments()) {
        SCOPED_TRACE(experiment.varied);
        const Loaded first = experiment.scene(experiment.levels[0]),
                     next = experiment.scene(experiment.levels[1]);
        const Quantities a = quantities_of(first.scene, first.views.front());
        const Quantities b = quantities_of(next.scene, next.views.front());
        const double growth = experiment.levels[1] / experiment.levels[0];
        if (experiment.varied == "vertices") {
            EXPECT_EQ(b.vertices, experiment.levels[1]);
            EXPECT_EQ(a.fragments, b.fragments);
            EXPECT_EQ(a.triangles, b.triangles);
        } else if (experiment.varied == "triangles") {
            EXPECT_EQ(b.triangles, experiment.levels[1]);
            EXPECT_EQ(a.vertices, b.vertices);
            EXPECT_EQ(b.fragments, 0);
        } else if (experiment.varied == "depth complexity") {
            EXPECT_EQ(b.fragments, growth * a.fragments);
            EXPECT_EQ(a.fragments, a.pixels);
            EXPECT_EQ(a.pixels, b.pixels);
        } else {
            EXPECT_EQ(experiment.varied, "pixels");
            EXPECT_EQ(b.pixels, growth * a.pixels);
            EXPECT_EQ(b.fragments, b.pixels);
            EXPECT_EQ(a.triangles, b.triangles);
        }
    }
}

TEST(CostExperiments, TogetherTellAllConstantsApartAndWholeFramesDoNot) {
    std::vector<Observation> apart, whole;
    for (const Experiment& experiment : experiments())
        for (const double level : experiment.levels) {
            if (level > 1e5 && experiment.varied == "vertices") continue;
            const Loaded loaded = experiment.scene(level);
            const Quantities q = quantities_of(loaded.scene, loaded.views.front());
            for (const Stages::Set stages : experiment.stages) apart.push_back({factors_of(q, stages), 1});
            whole.push_back({factors_of(q, Stages::all), 1});
        }
    EXPECT_EQ(fitted(apart).rank, int(constant_names().size()));
    EXPECT_EQ(fitted(whole).rank, int(constant_names().size()) - 2) << "k_bus, k_xform, k_shade are one";
    EXPECT_NEAR(fitted(whole).determined[0], 1.0 / 3, 1e-6);
}

TEST(CostPipeline, DrawsTheRasterizersFrame) {
    const Loaded loaded = generate_suite_scene("deep_overdraw", 200, 150);
    LecturePipeline pipeline(loaded.scene, loaded.views.front());
    pipeline.run(Stages::all);
    const Frame expected = rasterizer::render(loaded.scene, loaded.views.front());
    EXPECT_TRUE(std::ranges::equal(expected.primitive.pixels(), pipeline.frame().primitive.pixels()));
    EXPECT_TRUE(std::ranges::equal(expected.camera_depth.pixels(), pipeline.frame().camera_depth.pixels()));
}

Loaded two_spheres() {
    suite::MeshBuilder mesh("spheres");
    mesh.begin_part("near", {1, 1, 1});
    suite::add_sphere(mesh, {{0.4, 0, -4}, glm::dmat3(1)}, {.across = 24, .down = 12});
    mesh.begin_part("far", {1, 1, 1});
    suite::add_sphere(mesh, {{-0.4, 0, -7}, glm::dmat3(1.5)}, {.across = 24, .down = 12});
    return mesh.finish({suite::perspective_view("ahead", {160, 120}, {},
                                                {.half_height = 0.5, .near_depth = 0.5, .far_depth = 20})});
}

TEST(CostOptimizations, KeepThePictureOfAClosedSceneAndSaveWork) {
    const Loaded loaded = two_spheres();
    const OptimizationStudy study = study_optimizations(loaded.scene, loaded.views.front(), 1);
    EXPECT_EQ(study.open_edges, 0u);
    for (const OptimizationRun& run : study.runs) EXPECT_EQ(run.same.defects, 0u) << run.name;
    const auto named = [&](const char* name) -> const OptimizationRun& {
        return *std::ranges::find(study.runs, name, &OptimizationRun::name);
    };
    const OptimizationRun& plain = named("plain z-buffer");
    EXPECT_EQ(plain.same.other_ids + plain.same.other_depths, 0u);
    EXPECT_EQ(named("hierarchical z").same.other_ids, 0u);
    EXPECT_EQ(named("frustum culling").same.other_ids, 0u);
    EXPECT_EQ(named("front to back").same.other_depths, 0u);
    EXPECT_LT(named("back-face culling").work.bins.set_up, 0.6 * double(plain.work.bins.set_up));
    EXPECT_LT(named("hierarchical z").work.tally.fragments, plain.work.tally.fragments);
    EXPECT_LT(named("front to back").work.tally.written, plain.work.tally.written + 1);
    for (const ShadingRun& run : study.shading) EXPECT_EQ(run.other_colours, 0u) << run.name;
    EXPECT_GT(study.shading.front().shaded, study.shading.back().shaded);
}

// The gate is not deaf: what culling does to an open surface is a hole.
TEST(CostOptimizations, TheGateFindsBackFaceCullingOfAnOpenMesh) {
    const Loaded loaded = generate_suite_scene("back_faces", 160, 120);
    const OptimizationStudy study = study_optimizations(loaded.scene, loaded.views.front(), 1);
    EXPECT_GT(study.open_edges, 0u);
    const auto culled = std::ranges::find(study.runs, "back-face culling", &OptimizationRun::name);
    EXPECT_GT(culled->same.defects, 0u);
    EXPECT_EQ(study.runs.front().same.defects, 0u);
}

}  // namespace
}  // namespace zproof::study::cost
