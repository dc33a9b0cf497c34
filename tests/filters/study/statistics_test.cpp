#include "filters/study/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
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

/// Means 15 and 12; of two textures, samples have the first twice, both, or the second twice. Half the
/// distance of two values is their mean's standard error, and t has a single degree of freedom: 12.7062.
TEST(PooledScores, ByHand) {
    const PooledScores pool = pool_of(study_of({{{10, 11}}, {{20, 13}}}, {"steep", "flat"}));
    ASSERT_EQ(pool.methods.size(), 2u);
    EXPECT_EQ(pool.textures, 2u);
    EXPECT_EQ(pool.choice.baseline, "steep");
    const PooledMethod &steep = pool.methods[0], &flat = pool.methods[1];
    EXPECT_EQ(steep.label, "steep");
    EXPECT_EQ(steep.mean, 15);
    EXPECT_NEAR(steep.mean_spread.low, 15 - 12.7062 * 5, 1e-3);
    EXPECT_NEAR(steep.mean_spread.high, 15 + 12.7062 * 5, 1e-3);
    EXPECT_EQ(flat.rank, 2);
    EXPECT_EQ(flat.rank_spread.low, 1) << "where the first texture is drawn twice";
    EXPECT_EQ(flat.rank_spread.high, 2);
    EXPECT_NEAR(flat.first_share, 0.25, 0.02);
    EXPECT_EQ(flat.difference, -3);
    EXPECT_NEAR(flat.difference_spread.low, -3 - 12.7062 * 4, 1e-3);
    EXPECT_NEAR(flat.difference_spread.high, -3 + 12.7062 * 4, 1e-3);
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

TEST(PooledScores, OfOneTextureHaveNoInterval) {
    const PooledMethod method = pool_of(study_of({{{5}}}, {"one"})).methods.at(0);
    EXPECT_EQ(method.mean, 5);
    EXPECT_TRUE(std::isnan(method.mean_spread.low) && std::isnan(method.difference_spread.high));
}

/// Evenly spread within (0, 1).
double share(std::mt19937& engine) { return (static_cast<std::uint32_t>(engine()) + 0.5) * 0x1p-32; }

double exponential(std::mt19937& engine) { return -std::log(share(engine)); }

/// Box and Muller's.
double normal(std::mt19937& engine) {
    const double radius = std::sqrt(-2 * std::log(share(engine)));
    return radius * std::cos(2 * std::numbers::pi * share(engine));
}

/// Scores of methods crowd below a few that are far better.
double lopsided(std::mt19937& engine) {
    const double value = normal(engine);
    return share(engine) < 0.25 ? 3 + value : value;
}

/// How many intervals of so many values hold the mean that their distribution has.
double coverage(double (*draw)(std::mt19937&), double mean, std::size_t count) {
    constexpr int rounds = 20'000;
    std::mt19937 engine{11};
    int held = 0;
    for (int i = 0; i < rounds; ++i) {
        std::vector<double> values(count);
        for (double& value : values) value = draw(engine);
        const Spread interval = interval_of_mean(values);
        held += interval.low <= mean && mean <= interval.high;
    }
    return double(held) / rounds;
}

/// A share of 20 000 has a standard error of 0.0016. Student's t alone holds the exponential's mean in 0.90.
TEST(IntervalOfMean, HoldsTheMeanIn95Of100AlsoOfFewAndOfSkewedValues) {
    for (const std::size_t count : {2u, 3u, 8u, 20u}) {
        EXPECT_NEAR(coverage(normal, 0, count), 0.95, 0.01) << count;
        EXPECT_NEAR(coverage(lopsided, 0.75, count), 0.95, count < 8 ? 0.03 : 0.015) << count;
    }
    EXPECT_GT(coverage(exponential, 1, 3), 0.90);
    EXPECT_NEAR(coverage(exponential, 1, 8), 0.95, 0.03);
    EXPECT_NEAR(coverage(exponential, 1, 20), 0.95, 0.015);
}

/// It reaches farther where the values' tail is.
TEST(IntervalOfMean, LeansToTheTail) {
    const std::vector<double> values{0, 0, 0, 0, 0, 0, 0, 8};
    const Spread interval = interval_of_mean(values);
    EXPECT_GT(interval.high - 1, 1.5 * (1 - interval.low));
    std::vector<double> mirrored;
    for (const double value : values) mirrored.push_back(-value);
    EXPECT_EQ(interval_of_mean(mirrored).low, -interval.high);
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
