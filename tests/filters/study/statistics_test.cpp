#include "filters/study/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace zproof::study {
namespace {

/// A study by one metric. values[texture][view][method]
using Values = std::vector<std::vector<std::vector<double>>>;

StudyResults study_of(const Values& values, const std::vector<std::string>& labels,
                      bool higher_is_better = true) {
    StudyResults results;
    results.metrics = {{"score", "", "", higher_is_better}};
    for (const std::string& label : labels) results.methods.push_back({label, "", "", "", ""});
    for (std::size_t t = 0; t < values.size(); ++t)
        for (std::size_t v = 0; v < values[t].size(); ++v) {
            ViewStudy view{};
            view.scene = "texture " + std::to_string(t);
            view.view = std::to_string(v);
            for (std::size_t m = 0; m < labels.size(); ++m)
                view.methods.push_back({.label = labels[m],
                                        .regions = {{"interior", 10, 0, {values[t][v][m]}}},
                                        .cost = {},
                                        .flicker = {},
                                        .file = {}});
            results.views.push_back(view);
        }
    return results;
}

PooledScores pool_of(const StudyResults& results, const std::string& baseline = "") {
    return pooled(results, {.metric = "score", .baseline = baseline});
}

/// Means 15 and 12; of two textures, samples have the first twice, both, or the second twice.
TEST(PooledScores, ByHand) {
    const PooledScores pool = pool_of(study_of({{{10, 11}}, {{20, 13}}}, {"steep", "flat"}));
    ASSERT_EQ(pool.methods.size(), 2u);
    EXPECT_EQ(pool.textures, 2u);
    EXPECT_EQ(pool.choice.baseline, "steep");
    const PooledMethod &steep = pool.methods[0], &flat = pool.methods[1];
    EXPECT_EQ(steep.label, "steep");
    EXPECT_EQ(steep.mean, 15);
    EXPECT_EQ(steep.mean_spread.low, 10);
    EXPECT_EQ(steep.mean_spread.high, 20);
    EXPECT_EQ(flat.rank, 2);
    EXPECT_EQ(flat.rank_spread.low, 1) << "where the first texture is drawn twice";
    EXPECT_EQ(flat.rank_spread.high, 2);
    EXPECT_NEAR(flat.first_share, 0.25, 0.02);
    EXPECT_EQ(flat.difference, -3);
    EXPECT_EQ(flat.difference_spread.low, -7);
    EXPECT_EQ(flat.difference_spread.high, 1);
}

TEST(PooledScores, PutTheLeastFirstWhereLessIsBetter) {
    const PooledScores pool = pool_of(study_of({{{10, 11}}, {{20, 13}}}, {"steep", "flat"}, false));
    EXPECT_EQ(pool.methods[0].label, "flat");
    EXPECT_EQ(pool.methods[0].rank, 1);
}

/// A method that is better by 1 on every texture is better for certain, however textures differ.
TEST(PooledScores, PairDifferencesTextureByTexture) {
    Values values;
    for (int t = 0; t < 9; ++t) values.push_back({{10.0 * t, 10.0 * t + 1}});
    const PooledScores pool = pool_of(study_of(values, {"plain", "better"}), "plain");
    EXPECT_EQ(pool.methods[0].label, "better");
    EXPECT_EQ(pool.methods[0].difference_spread.low, 1);
    EXPECT_EQ(pool.methods[0].difference_spread.high, 1);
    EXPECT_EQ(pool.methods[0].first_share, 1);
    EXPECT_LT(pool.methods[0].mean_spread.low, pool.methods[0].mean - 10);
}

/// Of many textures the interval is that of the central limit theorem.
TEST(PooledScores, HaveTheIntervalsOfTheMean) {
    std::mt19937 engine{7};
    Values values;
    double sum = 0, squares = 0;
    constexpr int count = 400;
    for (int t = 0; t < count; ++t) {
        const double value = static_cast<std::uint32_t>(engine()) * 0x1p-32;
        values.push_back({{value}});
        sum += value, squares += value * value;
    }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    const PooledMethod method = pool_of(study_of(values, {"one"})).methods.at(0);
    EXPECT_NEAR(method.mean, mean, 1e-12);
    EXPECT_NEAR(method.mean_spread.low, mean - 1.96 * error, 0.1 * error);
    EXPECT_NEAR(method.mean_spread.high, mean + 1.96 * error, 0.1 * error);
}

/// Eight angles of one texture say no more about other textures than one does.
TEST(PooledScores, KeepTheViewsOfATextureTogether) {
    Values once, often;
    for (const double value : {1.0, 4.0, 9.0, 16.0}) {
        once.push_back({{value}});
        often.push_back({{value - 1}, {value}, {value + 1}});
    }
    const PooledMethod one = pool_of(study_of(once, {"a"})).methods[0],
                       many = pool_of(study_of(often, {"a"})).methods[0];
    EXPECT_EQ(one.mean, many.mean);
    EXPECT_EQ(one.mean_spread.low, many.mean_spread.low);
    EXPECT_EQ(one.mean_spread.high, many.mean_spread.high);
}

TEST(PooledScores, LeaveOutWhatLacksAView) {
    StudyResults results = study_of({{{1, 2}}, {{3, 4}}}, {"whole", "partly"});
    results.views[1].methods.pop_back();
    const PooledScores pool = pool_of(results);
    ASSERT_EQ(pool.methods.size(), 1u);
    EXPECT_EQ(pool.methods[0].label, "whole");
    EXPECT_EQ(pool.left_out, std::vector<std::string>{"partly"});
}

TEST(PooledScores, LeaveOutMethodsWhosePicturesHoldNoNumbers) {
    const double inf = std::numeric_limits<double>::infinity();
    const PooledScores pool = pool_of(study_of({{{1, 2}}, {{3, -inf}}}, {"whole", "broken"}));
    EXPECT_EQ(pool.left_out, std::vector<std::string>{"broken"});
    EXPECT_EQ(pool.textures, 2u);
}

TEST(PooledScores, OfOneTextureArePoints) {
    const PooledMethod method = pool_of(study_of({{{5}}}, {"one"})).methods.at(0);
    EXPECT_EQ(method.mean_spread.low, 5);
    EXPECT_EQ(method.mean_spread.high, 5);
}

TEST(PooledScores, LeaveOutTexturesOnWhichAMethodIsWithoutError) {
    const double inf = std::numeric_limits<double>::infinity();
    const PooledScores pool = pool_of(study_of({{{9, 2}}, {{inf, 4}}, {{7, 4}}}, {"exact", "other"}));
    EXPECT_EQ(pool.textures, 2u);
    EXPECT_EQ(pool.views, 2u);
    EXPECT_EQ(pool.textures_left_out, std::vector<std::string>{"texture 1"});
    EXPECT_EQ(pool.methods[0].mean, 8);
    EXPECT_EQ(pool.methods[1].mean, 3);
}

TEST(PooledScores, KnowTheirMethods) {
    EXPECT_THROW(pool_of(study_of({{{1}}}, {"one"}), "two"), std::invalid_argument);
}

}  // namespace
}  // namespace zproof::study
