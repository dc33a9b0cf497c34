/// Boxes of corners hold them, and a hull may part too little from its triangle, never what meets it.
#include "compare/search/corner_hull.h"

#include <gtest/gtest.h>

#include "compare/search/acquaintance.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

TEST(CornerBoxes, AreThoseOfEachCorner) {
    int known = 0, unknown = 0;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        const BoxProjection projection(s.view);
        for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t) {
            const CornersWorld p = corners_of(s.scene, t);
            const std::array one_by_one{projection(p[0]), projection(p[1]), projection(p[2])};
            const bool have_all = one_by_one[0] && one_by_one[1] && one_by_one[2];
            const auto boxes = projection.of_corners(p);
            ASSERT_EQ(boxes.has_value(), have_all);
            ++(have_all ? known : unknown);
            for (std::size_t corner = 0; boxes && corner < 3; ++corner) {
                const Box side_by_side = boxes->of(corner), &one = *one_by_one[corner];
                EXPECT_EQ(side_by_side.left, one.left);
                EXPECT_EQ(side_by_side.top, one.top);
                EXPECT_EQ(side_by_side.right, one.right);
                EXPECT_EQ(side_by_side.bottom, one.bottom);
                const Box all = boxes->all();
                EXPECT_TRUE(all.left <= one.left && all.top <= one.top);
                EXPECT_TRUE(all.right >= one.right && all.bottom >= one.bottom);
            }
        }
    }
    EXPECT_GT(known, 1000);
    EXPECT_GT(unknown, 300);
}

TEST(CornerBoxes, AreNoneOfNoPlace) {
    Dice dice(1);
    const BoxProjection projection(random_view(dice));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(projection.of_corners({glm::vec3{nan, 0, 0}, {0, nan, 0}, {0, 0, nan}}));
}

struct Corner {
    double x, y;
};
using Outline = std::array<Corner, 3>;

CornerBoxes boxes_around(const Outline& corners, double half_side) {
    CornerBoxes boxes{};
    for (std::size_t i = 0; i < four_count; ++i) {
        const Corner& corner = corners[std::min<std::size_t>(i, 2)];
        boxes.left[i] = corner.x - half_side, boxes.right[i] = corner.x + half_side;
        boxes.top[i] = corner.y - half_side, boxes.bottom[i] = corner.y + half_side;
    }
    return boxes;
}

Outline random_outline(Dice& dice) {
    Outline outline;
    for (Corner& corner : outline) corner = {dice.between(-40, 60), dice.between(-40, 60)};
    if (dice.below(8) == 0) outline[1] = outline[0];  // no triangle, yet a hull
    return outline;
}

Corner random_place_in(const Outline& t, Dice& dice) {
    double a = dice.between(0, 1), b = dice.between(0, 1);
    if (a + b > 1) a = 1 - a, b = 1 - b;
    return {t[0].x + a * (t[1].x - t[0].x) + b * (t[2].x - t[0].x),
            t[0].y + a * (t[1].y - t[0].y) + b * (t[2].y - t[0].y)};
}

TEST(CornerHull, PartsNoBoxThatHoldsAPlaceOfTheTriangle) {
    Dice dice(2);
    for (int i = 0; i < 20'000; ++i) {
        const Outline outline = random_outline(dice);
        const Corner at = random_place_in(outline, dice);
        const double width = dice.between(0, 4), height = dice.between(0, 4);
        const CornerHull hull(boxes_around(outline, 1e-9));
        EXPECT_FALSE(hull.is_beside({at.x - 1e-9, at.y - height, at.x + width, at.y + 1e-9}));
    }
}

/// How far the box lies from the triangle, across one of its sides; negative where they overlap.
double gap_across(const Outline& t, std::size_t side, const Box& box) {
    const Corner &p = t[side], &q = t[(side + 1) % 3];
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    const auto across = [&](double x, double y) { return ((p.y - q.y) * x + (q.x - p.x) * y) / length; };
    double least = across(t[0].x, t[0].y), most = least;
    for (const Corner& corner : t) {
        least = std::min(least, across(corner.x, corner.y));
        most = std::max(most, across(corner.x, corner.y));
    }
    const std::array of_box{across(box.left, box.top), across(box.right, box.top),
                            across(box.left, box.bottom), across(box.right, box.bottom)};
    return std::max(least - std::ranges::max(of_box), std::ranges::min(of_box) - most);
}

TEST(CornerHull, PartsWhatLiesBeyondASide) {
    Dice dice(3);
    std::array<int, 3> alone{};
    int beside = 0, met = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Outline outline = random_outline(dice);
        const Box box{dice.between(-40, 20), dice.between(-40, 20), dice.between(20, 60),
                      dice.between(20, 60)};
        const std::array gaps{gap_across(outline, 0, box), gap_across(outline, 1, box),
                              gap_across(outline, 2, box)};
        const bool is_beside = CornerHull(boxes_around(outline, 1e-9)).is_beside(box);
        int sides = 0;
        for (std::size_t side = 0; side < 3; ++side) sides += gaps[side] > 1e-6;
        ASSERT_TRUE(is_beside || sides == 0);
        ASSERT_FALSE(is_beside && std::ranges::all_of(gaps, [](double gap) { return gap < -1e-6; }));
        ++(is_beside ? beside : met);
        for (std::size_t side = 0; side < 3; ++side) alone[side] += sides == 1 && gaps[side] > 1e-6;
    }
    EXPECT_GT(beside, 1000);
    EXPECT_GT(met, 1000);
    for (const int side : alone) EXPECT_GT(side, 100) << "each side parts something that no other does";
}

/// Vectors are read as aligned, where an instruction set has such.
TEST(CornerHull, StandsAlignedWhereverItIsKept) {
    static_assert(alignof(CornerHull) == four_alignment && alignof(CornerBoxes) == four_alignment);
    const Surroundings s = random_surroundings(1);
    Acquaintance acquaintance(s.scene, s.view);
    for (std::uint32_t t = 0; t < s.scene.triangles.size(); ++t)
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&acquaintance.of(t).filter.hull) % four_alignment, 0u);
}

}  // namespace
}  // namespace zproof
