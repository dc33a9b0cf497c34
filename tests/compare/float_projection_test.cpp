/// Whatever box a corner has, its box in single precision must hold it, and not much more.
#include "compare/float_projection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "random_surroundings.h"

namespace zproof {
namespace {

bool holds(const FloatBox& outer, const Box& inner) {
    const Box box = outer.in_double();
    return box.left <= inner.left && inner.right <= box.right && box.top <= inner.top &&
           inner.bottom <= box.bottom;
}
/// By some units in the last place of its farthest side.
bool is_little_more(const FloatBox& outer, Box inner) {
    const double size = std::max(
        {1.0, std::abs(inner.left), std::abs(inner.right), std::abs(inner.top), std::abs(inner.bottom)});
    inner.widen(0x1p-20 * size);
    const Box box = outer.in_double();
    return inner.left <= box.left && box.right <= inner.right && inner.top <= box.top &&
           box.bottom <= inner.bottom;
}

TEST(FloatProjection, HoldsTheBoxesOfCorners) {
    int held = 0, everywhere = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const BoxProjection projection(s.view);
        const auto& p_world = s.scene.vertices.position_world;
        std::vector<FloatBox> boxes(p_world.size());
        FloatProjection(projection).project(p_world, boxes);
        for (std::size_t i = 0; i < p_world.size(); ++i) {
            const auto box = projection(p_world[i]);
            const bool is_everywhere = holds(boxes[i], FloatBox::everywhere().in_double());
            ASSERT_TRUE(box ? holds(boxes[i], *box) : is_everywhere) << i;
            ASSERT_TRUE(!box || is_everywhere || is_little_more(boxes[i], *box)) << i;
            ++(is_everywhere ? everywhere : held);
        }
    }
    EXPECT_GT(held, 1000);
    EXPECT_GT(everywhere, 300);
}

TEST(FloatProjection, ReachesEverywhereFromNoPlace) {
    const View view = [] {
        Dice dice(1);
        return random_view(dice);
    }();
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    huge = std::numeric_limits<float>::infinity();
    const std::array<glm::vec3, 3> p_world{glm::vec3{nan, 0, 0}, {0, huge, 0}, {0, 0, nan}};
    std::array<FloatBox, 3> boxes;
    FloatProjection(BoxProjection(view)).project(p_world, boxes);
    for (const FloatBox& box : boxes) EXPECT_TRUE(holds(box, FloatBox::everywhere().in_double()));
}

}  // namespace
}  // namespace zproof
