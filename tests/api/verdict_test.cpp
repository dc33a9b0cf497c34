// The public judge says what the judge says.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <thread>

#include "compare/judge.h"
#include "oracle/embree.h"
#include "rasterizer/rasterizer.h"
#include "scenes/suite.h"
#include "zproof/data.h"
#include "zproof/ids.h"
#include "zproof/zproof.h"

namespace zproof::api {
namespace {

constexpr const char* own_precision = "raster,transform=float64,subpixel_bits=8";

struct Arrays {
    std::vector<std::uint32_t> id;
    std::vector<float> depth;

    explicit Arrays(const Frame& frame)
        : id(frame.id().begin(), frame.id().end()), depth(frame.depth().begin(), frame.depth().end()) {}
};

/// Our picture of a scene with every hundredth pixel spoilt.
Arrays spoilt(const Scene& scene, const View& view) {
    Arrays arrays{render(scene, view)};
    std::mt19937 generator{7};
    for (std::size_t i = 0; i < arrays.id.size(); i += 100) {
        if (i % 300 == 0) arrays.id[i] = std::uint32_t(generator() % scene.triangle_count());
        if (i % 300 == 100) arrays.depth[i] *= 1.25f;
        if (i % 300 == 200) arrays.id[i] = background_id, arrays.depth[i] = INFINITY;
    }
    arrays.depth[5] = std::nanf("");
    return arrays;
}

TEST(ApiVerdict, IsTheJudgesOwn) {
    for (const char* name : {"room", "near_plane", "orthographic"}) {
        const Scene scene = Scene::load(name, {160, 90});
        for (const View& view : scene.views()) {
            const Arrays arrays = spoilt(scene, view);
            const Verdict verdict =
                judge(scene, view, {.id = arrays.id, .depth = arrays.depth, .precision = own_precision});
            zproof::Frame frame(Resolution{view.size().width, view.size().height});
            for (std::size_t i = 0; i < arrays.id.size(); ++i) {
                frame.primitive.pixels()[i] = PrimitiveId{arrays.id[i]};
                frame.camera_depth.pixels()[i] = arrays.depth[i];
            }
            const zproof::Scene& own_scene = scene.data().scene;
            const zproof::Frame reference = oracle::Embree{own_scene}.trace(view.data().view);
            const zproof::Verdict own = zproof::judge(
                own_scene, view.data().view,
                {frame, RasterPrecision{.transform = Arithmetic::float64, .subpixel_bits = 8}},
                {reference, oracle::embree_precision()}, {.findings = JudgeOptions::Findings::differences});
            EXPECT_TRUE(std::ranges::equal(verdict.counts(), own.counts));
            EXPECT_GT(verdict.defect_count(), 10u);
            ASSERT_EQ(verdict.findings().size(), own.findings.size());
            for (std::size_t i = 0; i < own.findings.size(); ++i) {
                EXPECT_EQ(verdict.findings()[i].x, own.findings[i].x);
                EXPECT_EQ(verdict.findings()[i].y, own.findings[i].y);
                EXPECT_EQ(verdict.findings()[i].pixel_class, std::uint32_t(own.findings[i].verdict));
                EXPECT_EQ(verdict.findings()[i].candidate_id,
                          std::uint32_t(own.findings[i].candidate.primitive));
            }
            const Size size = view.size();
            for (const Finding& f : verdict.findings())
                EXPECT_EQ(verdict.classes()[std::size_t(f.y * size.width + f.x)], f.pixel_class);
        }
    }
}

TEST(ApiVerdict, ReadsTheCallersMemory) {
    const Scene scene = Scene::load("guard_band", {64, 40});
    const View view = scene.views().front();
    const Arrays arrays{render(scene, view)};
    const Verdict verdict =
        judge(scene, view, {.id = arrays.id, .depth = arrays.depth, .precision = own_precision});
    EXPECT_TRUE(verdict.is_proven());
    EXPECT_FALSE(verdict.worst());
    EXPECT_FALSE(verdict.diagnosis());
    EXPECT_EQ(verdict.judged_id().data(), arrays.id.data());
    EXPECT_EQ(verdict.judged_depth().data(), arrays.depth.data());
    for (const char* ids : {"node", "none"}) {
        const Verdict of_labels = judge(
            scene, view, {.id = arrays.id, .depth = arrays.depth, .precision = own_precision, .ids = ids});
        EXPECT_EQ(of_labels.judged_depth().data(), arrays.depth.data()) << ids;
    }
}

TEST(ApiVerdict, OutlivesSceneAndView) {
    std::optional<Verdict> verdict;
    std::vector<float> depth;
    {
        const Scene scene = Scene::load("guard_band", {64, 40});
        const Arrays arrays{trace(scene, scene.views().front())};
        depth = arrays.depth;
        verdict = judge(scene, scene.views().front(), {.depth = depth, .precision = own_precision});
    }
    EXPECT_TRUE(verdict->is_proven());
    EXPECT_EQ(verdict->explain(3, 3).finding.x, 3);
}

TEST(ApiVerdict, TheWorstIsTheFarthestBeyondItsBound) {
    const Scene scene = Scene::load("room", {160, 90});
    const View view = scene.views().front();
    const Arrays arrays = spoilt(scene, view);
    const Verdict verdict =
        judge(scene, view, {.id = arrays.id, .depth = arrays.depth, .precision = own_precision});
    ASSERT_TRUE(verdict.worst());
    EXPECT_EQ(verdict.worst()->is_defect, 1u);
    for (const Finding& f : verdict.findings())
        EXPECT_FALSE(f.is_defect && f.error_over_bound > verdict.worst()->error_over_bound);
    const Explanation story = verdict.explain(5, 0);
    EXPECT_EQ(class_names()[story.finding.pixel_class], "invalid");
    EXPECT_NE(story.text.find("pixel (5, 0): invalid"), std::string::npos) << story.text;
    EXPECT_NE(verdict.sentence(*verdict.worst()), "");
    EXPECT_TRUE(verdict.diagnosis());
    EXPECT_THROW(verdict.explain(160, 0), InputError);
    EXPECT_THROW(verdict.explain(0, -1), InputError);
}

TEST(ApiVerdict, DepthAloneFindsDepthsThatNoSurfaceHas) {
    const Scene scene = Scene::load("room", {160, 90});
    const View view = scene.views().front();
    Arrays arrays{render(scene, view)};
    EXPECT_TRUE(judge(scene, view, {.depth = arrays.depth, .precision = own_precision}).is_proven());
    arrays.depth[160 * 45 + 80] *= 1.5f;
    const Verdict verdict = judge(scene, view, {.depth = arrays.depth, .precision = own_precision});
    EXPECT_EQ(verdict.defect_count(), 1u);
    EXPECT_EQ(verdict.worst()->x, 80);
}

TEST(ApiVerdict, LabelsStandForTheirTriangles) {
    const Scene scene = Scene::load("room", {160, 90});
    const View view = scene.views().front();
    Arrays arrays{render(scene, view)};
    const auto& parts = scene.data().scene.parts;
    for (std::uint32_t& id : arrays.id)
        for (const Part& part : parts)
            if (id != background_id && id >= part.first_triangle &&
                id - part.first_triangle < part.triangle_count) {
                id = std::uint32_t(part.material);
                break;
            }
    const Candidate candidate{
        .id = arrays.id, .depth = arrays.depth, .precision = own_precision, .ids = "material"};
    EXPECT_TRUE(judge(scene, view, candidate).is_proven());
    arrays.id[160 * 45 + 80] = background_id - 1;
    const Verdict verdict = judge(scene, view, candidate);
    EXPECT_EQ(verdict.defect_count(), 1u);
    EXPECT_NE(verdict.explain(80, 45).text.find("the frame says material"), std::string::npos)
        << verdict.explain(80, 45).text;
}

TEST(ApiVerdict, WhatIsNotUnderstoodIsRefused) {
    const Scene scene = Scene::load("guard_band", {64, 40});
    const View view = scene.views().front();
    const Arrays arrays{trace(scene, view)};
    const auto refused = [&](const Candidate& candidate) {
        EXPECT_THROW(judge(scene, view, candidate), InputError)
            << candidate.precision << " " << candidate.ids;
    };
    const std::span<const std::uint32_t> id = arrays.id;
    const std::span<const float> depth = arrays.depth;
    refused({.precision = own_precision});
    refused({.id = id, .depth = depth});
    refused({.id = id, .depth = depth, .precision = "no_such_preset"});
    refused({.id = id, .depth = depth, .precision = "raster,subpixel_bits=many"});
    refused({.id = id, .depth = depth, .precision = own_precision, .ids = "planet"});
    refused({.id = id.first(100), .depth = depth, .precision = own_precision});
    refused({.id = id, .depth = depth.first(100), .precision = own_precision});
    refused({.id = id, .precision = own_precision, .ids = "material"});
}

TEST(ApiVerdict, ManyThreadsMayJudgeOneScene) {
    const Scene scene = Scene::load("room", {96, 54});
    const View view = scene.views().front();
    const Arrays arrays = spoilt(scene, view);
    std::vector<std::uint64_t> defects(4);
    {
        std::vector<std::jthread> threads;
        for (std::uint64_t& found : defects)
            threads.emplace_back([&] {
                found =
                    judge(scene, view, {.id = arrays.id, .depth = arrays.depth, .precision = own_precision})
                        .defect_count();
            });
    }
    for (const std::uint64_t found : defects) EXPECT_EQ(found, defects.front());
    EXPECT_GT(defects.front(), 0u);
}

}  // namespace
}  // namespace zproof::api
