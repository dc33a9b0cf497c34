/// A triangle has one place in a tile, and there its own laws, whatever earlier tiles showed.
#include "compare/first_pass/shown_triangles.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <map>

#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

/// More walls than a tile's first table has room for, no two alike.
Scene many_walls(const View& view) {
    std::vector<Triangle> walls;
    walls.reserve(3000);
    for (int i = 0; i < 3000; ++i) walls.push_back(wall(2 + 0.001 * i));
    return scene_of(view, walls);
}

bool are_the_same(const DepthLaw& a, const DepthLaw& b) {
    using Bits = std::array<std::uint64_t, sizeof(DepthLaw) / sizeof(double)>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

TEST(ShownTriangles, HaveOnePlaceEachAndTheirOwnLaws) {
    const View view = pixel_view(Projection::perspective, 4, 4);
    const Scene scene = many_walls(view);
    const Frame frame({view.width, view.height});
    const Witness ours(scene, view, {frame, RasterPrecision{.transform = Arithmetic::float64}}),
        theirs(scene, view, {frame, RayPrecision{}});
    ShownTriangles shown(scene, ours, theirs);
    Dice dice(1);
    for (int tile = 0; tile < 60; ++tile) {
        SCOPED_TRACE(tile);
        shown.clear();
        EXPECT_EQ(shown.count(), 0u);
        std::map<std::uint32_t, std::uint32_t> places;
        const int looks = tile % 10 == 9 ? 5000 : dice.below(400);
        for (int i = 0; i < looks; ++i) {
            const auto id = std::uint32_t(dice.below(3000));
            const std::uint32_t place = shown.place_of(PrimitiveId(id));
            ASSERT_EQ(places.try_emplace(id, place).first->second, place);
            ASSERT_EQ(shown.count(), places.size()) << "each new one takes a place";
            if (dice.below(100) == 0) {
                EXPECT_GE(shown.laws().candidate.size(), shown.count());
            }
        }
        const PixelBox part{0, 0, view.width, 1 + tile % 4};
        std::vector<DepthTolerance> tolerances(7);
        std::vector<CornerTolerance> next_to_corners(9);
        shown.set_tolerances(part, tolerances, next_to_corners);
        ASSERT_EQ(tolerances.size(), places.size() + 1);
        ASSERT_EQ(next_to_corners.size(), places.size() + 1);
        EXPECT_GT(next_to_corners[0].least, next_to_corners[0].most) << "where nobody stands";
        EXPECT_GT(tolerances[0].least, tolerances[0].most) << "where nobody stands";
        std::vector<bool> is_taken(places.size() + 1);
        is_taken[0] = true;
        for (const auto& [id, place] : places) {
            ASSERT_LE(place, places.size());
            ASSERT_FALSE(is_taken[place]);
            is_taken[place] = true;
            const TriangleInView triangle = ours.triangle_in_view(PrimitiveId(id));
            const DepthLaw &our_law = shown.laws().candidate[place],
                           &their_law = shown.laws().reference[place];
            EXPECT_TRUE(are_the_same(our_law, depth_law_of(triangle, ours.bounds())));
            EXPECT_TRUE(are_the_same(their_law, depth_law_of(triangle, theirs.bounds())));
            const auto [expected, expected_next_to] =
                tolerances_of(our_law, their_law, Projection::perspective, part);
            EXPECT_EQ(next_to_corners[place].least, expected_next_to.least);
            EXPECT_EQ(tolerances[place].w_offset, expected.w_offset);
            EXPECT_EQ(tolerances[place].least, expected.least);
            EXPECT_EQ(tolerances[place].candidate.room, expected.candidate.room);
        }
    }
}

}  // namespace
}  // namespace zproof
