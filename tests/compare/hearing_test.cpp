/// Answers heard together earn what each earns by itself.
#include "compare/hearing/hearing.h"

#include <gtest/gtest.h>

#include "stage.h"

namespace zproof {
namespace {

RasterPrecision with_subpixel_bits(int bits) {
    return {.transform = Arithmetic::float64, .subpixel_bits = bits};
}

/// In the square of half-side 1/8 around the only place asked about, but farther from it than 1/12, two walls
/// meet in front of a third.
class ACoarseAnswerAmongFineOnes : public testing::TestWithParam<Projection> {
  protected:
    static constexpr double seam_x = 2.609375, front_depth = 1, back_depth = 4;
    static constexpr std::uint32_t back = 2;

    View view = pixel_view(GetParam(), 16, 16);
    Scene scene = scene_of(
        view, {wall_left_of(seam_x, front_depth), wall_right_of(seam_x, front_depth), wall(back_depth)});
    ViewBounds fine{view, with_subpixel_bits(8)}, coarse{view, with_subpixel_bits(2)};

    /// Of that triangle by the coarse renderer, after so many of the fine one in the same tile.
    Ruled heard_after(std::size_t fine_ones, PrimitiveId answer) const {
        Bulk<Plea> pleas;
        for (std::size_t i = 0; i < fine_ones; ++i) pleas.push_back({&fine, PrimitiveId(0), 0, int(i)});
        pleas.push_back({&coarse, answer, 2, 2});
        return Hearing(scene, view).hear(pleas, Asked::standing_and_displacement).back();
    }
};

TEST_P(ACoarseAnswerAmongFineOnes, IsHeardByAllThatItsOwnSquareReaches) {
    const Ruled alone = heard_after(0, PrimitiveId(back));
    EXPECT_EQ(alone.decision.standing, Standing::hidden);
    EXPECT_GE(alone.eps_px, 0.125);
    for (std::uint32_t triangle = 0; triangle < scene.triangles.size(); ++triangle) {
        SCOPED_TRACE(triangle);
        const Ruled expected = heard_after(0, PrimitiveId(triangle));
        for (std::size_t fine_ones = 1; fine_ones < 5; ++fine_ones) {
            const Ruled ruled = heard_after(fine_ones, PrimitiveId(triangle));
            EXPECT_EQ(ruled.decision.standing, expected.decision.standing);
            EXPECT_EQ(ruled.eps_px, expected.eps_px);
            EXPECT_EQ(ruled.displacement_over_eps, expected.displacement_over_eps);
        }
    }
}

/// Fine answers in every tile say that triangles need not be looked for far. In one, which no sample meets, a
/// coarse answer's edge passes through the centre; two walls that overlap right beside it leave only a crack
/// of its triangle, and only one of them comes as near as triangles are looked for.
TEST(Hearing, GlancesNoFartherThanTrianglesAreLookedFor) {
    constexpr int tiles = 40, x = 20, y = 8;
    constexpr double centre_x = x + 0.5;
    const View view = pixel_view(Projection::parallel, tiles * 16, 16);
    const Scene scene = scene_of(view, {wall_right_of(centre_x, 8), wall_left_of(centre_x + 0x1p-11, 4),
                                        wall_right_of(centre_x + 0x1p-12, 4)});
    const ViewBounds fine(view, RayPrecision{.arithmetic = Arithmetic::float64}),
        coarse(view, with_subpixel_bits(-3));
    Bulk<Plea> pleas;
    for (int tile = 0; tile < tiles; ++tile)
        if (tile != x / 16)
            for (int row = 0; row < 16; ++row) pleas.push_back({&fine, PrimitiveId(2), tile * 16, row});
    pleas.push_back({&coarse, PrimitiveId(0), x, y});
    for (const Asked asked : {Asked::standing_and_displacement, Asked::without_square})
        EXPECT_EQ(Hearing(scene, view).hear(pleas, asked).back().decision.standing,
                  Standing::through_a_crack);
}

/// From tile to tile and back, and some that ask nothing: each ruling is its own plea's.
TEST(Hearing, GivesRulingsInTheOrderOfPleas) {
    constexpr double edge_x = 20;
    const View view = pixel_view(Projection::parallel, 64, 32);
    const Scene scene = scene_of(view, {wall_left_of(edge_x, 4)});
    const ViewBounds bounds(view, with_subpixel_bits(8));
    Bulk<Plea> pleas;
    for (int i = 0; i < 5000; ++i) {
        const int x = i * 37 % 64, y = i * 11 % 32;
        pleas.push_back(i % 7 == 0 ? Plea{} : Plea{&bounds, PrimitiveId(0), x, y});
    }
    const Bulk<Ruled> rulings = Hearing(scene, view).hear(pleas);
    ASSERT_EQ(rulings.size(), pleas.size());
    for (std::size_t i = 0; i < pleas.size(); ++i) {
        const bool is_asked = pleas[i].bounds != nullptr;
        ASSERT_EQ(rulings[i].decision.standing,
                  is_asked && pleas[i].x >= edge_x ? Standing::outside : Standing::visible);
        ASSERT_EQ(rulings[i].eps_px > 0, is_asked) << "of what asks nothing the ruling is empty";
    }
}

INSTANTIATE_TEST_SUITE_P(Projections, ACoarseAnswerAmongFineOnes,
                         testing::Values(Projection::perspective, Projection::parallel));

}  // namespace
}  // namespace zproof
