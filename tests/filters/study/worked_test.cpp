// The worked set-up of the reference on texture filters, through the whole study: rasterizer, area integral,
// metrics and costs (docs/filters.md).
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "filters/methods/catalogue.h"
#include "filters/study/claims.h"
#include "filters/study/cost.h"
#include "filters/study/study.h"
#include "filters/study/surface_map.h"
#include "rasterizer/rasterizer.h"
#include "scenes/filters/filter_scenes.h"

namespace zproof::study {
namespace {

struct Row {
    const char* label;
    const char* method;
    int subdivisions;
    double texels, psnr;
};

/// What a summed-area table reads depends on how a box is cut where the texture repeats; the printed counts
/// (16.6, 16.4, 16.6 and 75.6) are of another way to cut it.
constexpr double not_held = 0;

constexpr Row rows[] = {{"nearest", "nearest", 4, 1.0, 13.88},
                        {"bilinear", "bilinear", 4, 4.0, 14.82},
                        {"trilinear-gl", "trilinear-gl", 4, 7.4, 22.82},
                        {"trilinear-area", "trilinear-area", 4, 7.1, 21.65},
                        {"ripmap", "ripmap", 4, 16.0, 26.82},
                        {"sat-affine", "sat-affine", 4, not_held, 26.35},
                        {"sat-area", "sat-area", 4, not_held, 23.83},
                        {"sat-moment", "sat-moment", 4, not_held, 27.06},
                        {"sat-strips:n=16", "sat-strips", 16, not_held, 39.52},
                        {"aniso-ext-linear", "aniso-ext-linear", 4, 31.7, 33.54},
                        {"aniso-midpoint", "aniso-midpoint", 4, 31.7, 40.50},
                        {"aniso-d3d11", "aniso-d3d11", 4, 33.3, 40.97},
                        {"ewa-pbrt", "ewa-pbrt", 4, 40.2, 28.28},
                        {"supersample-nearest:n=8", "supersample-nearest", 8, 64.0, 32.08}};

const ProgressSink nobody{.begins = [](const std::string&, double) {},
                          .is_shown = [](const std::string&, const Picture&) {},
                          .wants_to_stop = [] { return false; }};

Plan worked_plan() {
    Plan plan{.methods = {}, .truth = oracle::Reconstruction::nearest, .flicker_steps = 0, .first_row = 56};
    for (const Row& row : rows)
        plan.methods.push_back(
            {row.label,
             {.method = *texture::find_method(row.method), .options = {.subdivisions = row.subdivisions}}});
    return plan;
}

/// The printed counts of reads include four rows more than the printed errors: rows 52 to 255.
std::vector<Lookup> printed_lookups(const Loaded& loaded) {
    Frame frame = rasterizer::render(loaded.scene, loaded.views[0]);
    for (int y = 0; y < 52; ++y) std::ranges::fill(frame.primitive.row(y), PrimitiveId::none);
    return lookups(loaded.scene, loaded.views[0], frame, 1 << 16);
}

TEST(WorkedSetup, EveryFigureToATenthOfADecibel) {
    const Loaded loaded = generate_filter_scene("worked", 256, 256);
    const Plan plan = worked_plan();
    StudyResults results = begun(plan);
    const ViewStudy view = study_view(loaded.scene, loaded.views[0], plan, nobody);
    const SourceTextures textures = source_textures(loaded.scene);
    const std::vector<Lookup> counted = printed_lookups(loaded);
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        const MethodScore& method = view.methods[i];
        EXPECT_EQ(find_score(method, "interior")->pixels, 51'200u);
        EXPECT_NEAR(value_of(results, method, "interior", "psnr"), rows[i].psnr, 0.1) << rows[i].label;
        const Cost cost = cost_of(plan.methods[i].texturing, textures, counted);
        if (rows[i].texels == not_held) continue;
        EXPECT_NEAR(cost.texels, rows[i].texels, 0.1) << rows[i].label;
    }
}

/// All but the times is the same for any number of threads.
TEST(WorkedSetup, ThreadsDoNotMatter) {
    const Loaded loaded = generate_filter_scene("worked", 64, 64);
    Plan plan = worked_plan();
    plan.methods.resize(3);
    plan.flicker_steps = 1;
    plan.first_row = 14;
    const auto scores_on = [&](int threads) {
        std::vector<double> values;
        tbb::task_arena arena{threads};
        const ViewStudy view =
            arena.execute([&] { return study_view(loaded.scene, loaded.views[0], plan, nobody); });
        for (const MethodScore& method : view.methods) {
            for (const RegionScore& region : method.regions)
                if (region.pixels > 0)
                    values.insert(values.end(), region.values.begin(), region.values.end());
            values.insert(values.end(), {method.cost.texels, method.cost.lines, method.flicker.rms});
        }
        return values;
    };
    EXPECT_EQ(scores_on(1), scores_on(2));
}

TEST(WorkedSetup, AProgressSinkMayStopItBetweenMethods) {
    const Loaded loaded = generate_filter_scene("worked", 16, 16);
    int begun_units = 0;
    const ProgressSink impatient{.begins = [&](const std::string&, double) { ++begun_units; },
                                 .is_shown = [](const std::string&, const Picture&) {},
                                 .wants_to_stop = [&] { return begun_units == 3; }};
    EXPECT_EQ(study_view(loaded.scene, loaded.views[0], worked_plan(), impatient).methods.size(), 2u);
}

}  // namespace
}  // namespace zproof::study
