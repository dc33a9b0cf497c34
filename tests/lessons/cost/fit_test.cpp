#include "lessons/cost/fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/suite/random.h"

namespace zproof::study::cost {
namespace {

TEST(CostFit, FindsTheConstantsOfRowsThatKeepToThem) {
    const std::vector<double> truth{3, 0.5, 40};
    suite::Random random{1};
    std::vector<Observation> rows;
    for (int i = 0; i < 12; ++i) {
        const double a = random.uniform(1, 1000), b = random.uniform(1, 1e6);
        const std::vector<double> factor{a, b, 1};
        rows.push_back({factor, predicted(truth, factor)});
    }
    const Fit fit = fitted(rows);
    for (std::size_t j = 0; j < truth.size(); ++j) {
        EXPECT_NEAR(fit.constant[j] / truth[j], 1, 1e-8);
        EXPECT_NEAR(fit.determined[j], 1, 1e-9);
        EXPECT_LT(fit.standard_error[j], 1e-6 * truth[j]);
    }
    EXPECT_EQ(fit.rank, 3);
    EXPECT_LT(fit.largest_residual, 1e-10);
}

// k_bus, k_xform and k_shade all multiply v where no stage is ever left out.
TEST(CostFit, SaysThatEqualColumnsAreKnownAsASumOnly) {
    std::vector<Observation> rows;
    for (int i = 1; i <= 6; ++i) rows.push_back({{double(i), double(i), 1}, 10.0 * i + 7});
    const Fit fit = fitted(rows);
    EXPECT_EQ(fit.rank, 2);
    EXPECT_NEAR(fit.determined[0], 0.5, 1e-9);
    EXPECT_NEAR(fit.determined[2], 1, 1e-9);
    EXPECT_TRUE(std::isnan(fit.standard_error[0]));
    EXPECT_FALSE(std::isnan(fit.standard_error[2]));
    EXPECT_NEAR(fit.constant[0] + fit.constant[1], 10, 1e-9);
}

TEST(CostFit, ItsStandardErrorsCoverTheTruth) {
    suite::Random random{5};
    int covered = 0;
    for (int trial = 0; trial < 400; ++trial) {
        std::vector<Observation> rows;
        for (int i = 0; i < 30; ++i) {
            const std::vector<double> factor{random.uniform(0, 10), random.uniform(0, 10)};
            const double truth = predicted({2, 5}, factor);
            // A sum of 12 uniform numbers is nearly normal, variance 1.
            double noise = -6;
            for (int k = 0; k < 12; ++k) noise += random.uniform(0, 1);
            rows.push_back({factor, truth * (1 + 0.02 * noise)});
        }
        const Fit fit = fitted(rows);
        covered += std::abs(fit.constant[0] - 2) < 2 * fit.standard_error[0] ? 1 : 0;
    }
    // 95 in a hundred; 400 trials leave a deviation of 1.1 in a hundred.
    EXPECT_GT(covered, 0.91 * 400);
    EXPECT_LT(covered, 0.985 * 400);
}

TEST(CostFit, RefusesWhatCannotBeFitted) {
    EXPECT_THROW(fitted({}), std::invalid_argument);
    EXPECT_THROW(fitted({{{1, 2}, 1}}), std::invalid_argument);
    EXPECT_THROW(fitted({{{1}, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace zproof::study::cost
