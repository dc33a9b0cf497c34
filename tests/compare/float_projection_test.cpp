/// Whatever box a corner has, its box in single precision must hold it, and not much more.
#include "compare/search/float_projection.h"

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
/// By some units of single precision: of the corner's distance from the eye, seen from its depth, of its
/// place in the window and in the image, and of its own size.
bool is_little_more(const FloatBox& outer, Box inner, const BoxProjection::Terms& terms,
                    const glm::vec3& p_world) {
    const Camera& c = terms.camera;
    const glm::dvec3 v = glm::dvec3(p_world) - glm::dvec3(c.eye_world);
    const double distance = std::abs(v.x) + std::abs(v.y) + std::abs(v.z),
                 depth = terms.perspective ? -dot(c.back, v) : 1;
    const double in_image = std::abs(inner.middle_x()) + std::abs(inner.middle_y()),
                 px_per_u = std::max(terms.px_per_u, terms.px_per_v),
                 of_window = std::abs(c.window.left) + std::abs(c.window.top),
                 in_window = in_image / std::min(terms.px_per_u, terms.px_per_v) + of_window,
                 oblique = terms.perspective ? in_window : 2 * (std::abs(c.shear.x) + std::abs(c.shear.y));
    const double spread = distance / depth * (1 + oblique);
    const double own_size = inner.right - inner.left + inner.bottom - inner.top;
    inner.widen(0x1p-19 * (px_per_u * (spread + in_window + of_window) + in_image + own_size) + 0x1p-31);
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
            ASSERT_TRUE(!box || is_everywhere ||
                        is_little_more(boxes[i], *box, projection.terms(), p_world[i]))
                << i;
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
