/// Whatever box a triangle has, the cells of its corners must hold it.
#include "compare/corner_cells.h"

#include <gtest/gtest.h>

#include "random_surroundings.h"

namespace zproof {
namespace {

bool is_within(const Cells& cells, const Box& box, const CellReach& reach) {
    return reach.left() <= cells.column_of(box.left) && cells.column_of(box.right) <= reach.right() &&
           reach.top() <= cells.row_of(box.top) && cells.row_of(box.bottom) <= reach.bottom();
}

Box whole_image(const View& view) { return {0, 0, double(view.width), double(view.height)}; }

TEST(CornerCells, HoldTheBoxesOfCornersAndTriangles) {
    int held = 0, everywhere = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        Surroundings s = random_surroundings(seed);
        const BoxProjection projection(s.view);
        const Cells cells(s.view);
        const auto& p_world = s.scene.vertices.position_world;
        std::vector<CellReach> reach(p_world.size());
        CornerCells(projection, cells).find(p_world, reach);
        for (std::size_t i = 0; i < p_world.size(); ++i) {
            const auto box = projection(p_world[i]);
            ASSERT_TRUE(!box || is_within(cells, *box, reach[i])) << i;
        }
        for (const glm::uvec3& v : s.scene.triangles) {
            const CellReach all = CellReach::of(reach[v.x], reach[v.y], reach[v.z]);
            const bool is_everywhere = is_within(cells, whole_image(s.view), all);
            Box box;
            bool are_known = true;
            for (const std::uint32_t corner : {v.x, v.y, v.z}) {
                const auto one = projection(p_world[corner]);
                are_known &= one.has_value();
                if (one) box.add(*one);
            }
            ASSERT_TRUE(are_known ? is_within(cells, box, all) : is_everywhere);
            ++(is_everywhere ? everywhere : held);
        }
    }
    EXPECT_GT(held, 1000);
    EXPECT_GT(everywhere, 300);
}

TEST(CornerCells, ReachEverywhereFromNoPlace) {
    const View view = [] {
        Dice dice(1);
        return random_view(dice);
    }();
    const Cells cells(view);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                    huge = std::numeric_limits<float>::infinity();
    const std::array<glm::vec3, 3> p_world{glm::vec3{nan, 0, 0}, {0, huge, 0}, {0, 0, nan}};
    std::array<CellReach, 3> reach;
    CornerCells(BoxProjection(view), cells).find(p_world, reach);
    for (const CellReach& r : reach) {
        EXPECT_EQ(r.left(), 0);
        EXPECT_EQ(r.top(), 0);
        EXPECT_EQ(r.right(), cells.columns - 1);
        EXPECT_EQ(r.bottom(), cells.rows - 1);
    }
}

}  // namespace
}  // namespace zproof
