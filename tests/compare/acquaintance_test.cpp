/// What a thread knows of triangles: the same after it forgot, and never many more than it may.
#include "compare/search/acquaintance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

TEST(Acquaintance, KnowsTheSameAfterItForgot) {
    constexpr std::size_t much = 3;
    std::size_t most = 0, times_forgotten = 0;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const ViewBounds ours(s.view, RasterPrecision{}), theirs(s.view, RayPrecision{});
        const Sight<double> sight(s.view, s.x, s.y);
        Acquaintance lasting(s.scene, s.view), brief(s.scene, s.view, much);
        Dice dice(seed);
        for (int i = 0; i < 60; ++i) {
            const std::size_t before = brief.count();
            brief.forget_if_much();
            times_forgotten += brief.count() < before;
            const auto t = std::uint32_t(dice.below(int(s.scene.triangles.size())));
            const double reach_px = dice.below(2) * 0x1p-9;
            ASSERT_EQ(brief.of(t).filter.is_near(s.x, s.y, reach_px),
                      lasting.of(t).filter.is_near(s.x, s.y, reach_px));
            for (const ViewBounds* bounds : {&ours, &theirs})
                ASSERT_EQ(brief.of(t, *bounds).of_view.eps_px(sight),
                          lasting.of(t, *bounds).of_view.eps_px(sight));
            most = std::max(most, brief.count());
        }
    }
    EXPECT_EQ(most, much + 1);
    EXPECT_GT(times_forgotten, 100u);
}

}  // namespace
}  // namespace zproof
