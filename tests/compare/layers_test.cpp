/// What may be decided for a whole tile must hold at each of its pixels.
#include "compare/layers/layers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

constexpr int side = int(tile_columns);

/// Two walls whose nearness differs by about as much as a renderer's depth may be wrong. Both may slope, and
/// the gap between them may open across the tile.
Scene random_pair(Dice& dice, const View& view) {
    const bool is_parallel = view.camera.projection == Projection::parallel;
    const double gap = std::ldexp(dice.between(1, 2), -16 - dice.below(12));
    const double slope = dice.below(2) ? dice.between(-0.02, 0.02) : 0;
    const double opening = dice.below(2) ? gap * dice.between(-0.1, 0.1) : 0;
    const auto wall_behind = [&](double share) {  // a share of the gap
        const auto corner = [&](double x, double y) {
            const double nearness = 0.125 * (1 + slope * x) - share * (gap + opening * x) * 0.125;
            return Corner{x, y, is_parallel ? 16 - 8 * nearness : 1 / nearness};
        };
        return Triangle{corner(0, -20), corner(36, 40), corner(-36, 40)};
    };
    return scene_of(view, {wall_behind(0), wall_behind(1)});
}

/// Of the pixel by itself: what a faultless renderer may hold for the nearness of each triangle.
std::array<Neighbour, 2> alone(const ViewBounds& bounds, const Scene& scene, const Sight<double>& sight) {
    const auto seen = [&](std::uint32_t t) {
        const CornersWorld p_world = corners_of(scene, t);
        const ViewedTriangle viewed{sight, p_world, bounds.extent_of(p_world)};
        return neighbour_of(sight, TriangleOfView{bounds, viewed});
    };
    return {seen(0), seen(1)};
}

/// A wall that is in front for certain at a pixel must not pass for one that ties there, though it be close
/// elsewhere in the tile.
TEST(Layers, TieNowhereWithAWallThatIsInFrontForCertain) {
    std::size_t tied = 0, apart = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view =
            pixel_view(dice.below(3) ? Projection::perspective : Projection::parallel, side, side);
        const Scene scene = random_pair(dice, view);
        const std::array<Precision, 3> promises{raster_precision(), ray_precision(),
                                                RayPrecision{.arithmetic = Arithmetic::float64}};
        const ViewBounds bounds(view, promises[std::size_t(dice.below(3))]);
        const Sights<double> sights(view);
        Acquaintance acquaintance(scene, view);
        CoplanarMemory coplanar(16);
        const std::array<std::uint32_t, 2> near{0, 1};
        const std::array<const ViewBounds*, 1> renderers{&bounds};
        constexpr double middle = (side - 1) / 2.0;
        Layers layers({sights, acquaintance, coplanar});
        layers.turn_to({-16, 0}, {middle - 16, middle, middle, middle}, near, renderers);
        layers.standings(0, 0, layers.uncut(TileMask::all()));
        layers.turn_to({0, 0}, {middle, middle, middle, middle}, near, renderers);
        ASSERT_TRUE(layers.are_known());
        const TileMask as_tied = layers.standings(0, 1, layers.uncut(TileMask::all())).tied;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto [front, back] = alone(bounds, scene, sights.at(x, y));
                const bool is_apart = front.least_nearness > back.greatest_nearness;
                EXPECT_FALSE(is_apart && (as_tied.row(y) >> x & 1) != 0) << x << ", " << y;
                ++(is_apart ? apart : tied);
            }
        if (HasFailure()) return;
    }
    EXPECT_GT(tied, 100'000u);
    EXPECT_GT(apart, 100'000u);
}

}  // namespace
}  // namespace zproof
