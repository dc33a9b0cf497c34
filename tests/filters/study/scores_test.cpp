#include "filters/study/scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "filters/metrics/picture_metric.h"
#include "filters/study/study.h"
#include "rasterizer/texel_map.h"
#include "scenes/filters/filter_scenes.h"

namespace zproof::study {
namespace {

constexpr Resolution size{3, 2};

LinearPicture flat(double value) { return LinearPicture(size, glm::dvec3{value}); }

TEST(Scores, EveryRegionHasEveryMetricAndTheTruthsCertainty) {
    Region all{"all", Plane<std::uint8_t>(size, 1), 6}, none{"none", Plane<std::uint8_t>(size, 0), 0};
    const std::vector<Region> regions{all, none};
    Plane<double> half_width(size, 0.01);
    half_width.at(0, 0) = 0.05;
    const std::vector<RegionScore> found = scores(flat(0.5), flat(0.25), half_width, regions);
    ASSERT_EQ(found.size(), 2u);
    ASSERT_EQ(found[0].values.size(), picture_metrics().size());
    EXPECT_EQ(found[0].values[0], 0.25);  // rmse
    EXPECT_NEAR(found[0].truth_half_width, std::sqrt((5 * 1e-4 + 25e-4) / 6), 1e-15);
    EXPECT_TRUE(std::isnan(found[1].values[0]));
}

/// Pictures 0, 0.5, 0.5 against truths 0, 0.25, 0.5: changes (0.5, 0) and (0.25, 0.25).
TEST(Flicker, ByHand) {
    const std::vector<LinearPicture> pictures{flat(0), flat(0.5), flat(0.5)},
        truths{flat(0), flat(0.25), flat(0.5)};
    const Flicker found = flicker(pictures, truths, Plane<std::uint8_t>(size, 1));
    EXPECT_EQ(found.steps, 2);
    EXPECT_NEAR(found.rms, 0.25, 1e-15);
    EXPECT_NEAR(found.ratio, std::sqrt(0.25 / 0.125), 1e-15);
}

TEST(Flicker, NeedsTwoViewsAndAPixel) {
    const std::vector<LinearPicture> one{flat(0)}, two{flat(0), flat(1)};
    EXPECT_EQ(flicker(one, one, Plane<std::uint8_t>(size, 1)).steps, 0);
    EXPECT_EQ(flicker(two, two, Plane<std::uint8_t>(size, 0)).steps, 0);
}

TEST(ShiftedView, SeesAtXMinusDxWhatWasSeenAtX) {
    const Loaded loaded = generate_filter_scene("worked", 64, 64);
    const View moved = shifted(loaded.views[0], 0.37, -1.25);
    const auto before = *rasterizer::texels_from_raster(loaded.scene, loaded.views[0], 0);
    const auto after = *rasterizer::texels_from_raster(loaded.scene, moved, 0);
    const auto [u, v] = before.at(20.5, 50.5);
    const auto [u_moved, v_moved] = after.at(20.5 - 0.37, 50.5 + 1.25);
    EXPECT_NEAR(u_moved, u, 1e-6 * std::abs(u));
    EXPECT_NEAR(v_moved, v, 1e-6 * std::abs(v));
}

}  // namespace
}  // namespace zproof::study
