/// What runs by themselves are certain of must be what the whole formula finds, and the same for every
/// kernel.
#include "compare/first_pass/run_lens.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "compare/first_pass/held_depths.h"
#include "compare/strips/certain_depths.h"
#include "compare/strips/dispatch.h"
#include "compare/truth/depth_bound.h"
#include "random_surroundings.h"
#include "stage.h"

namespace zproof {
namespace {

/// Renderers whose terms hold for every triangle; the last one's errors have no limit.
Precision some_precision(Dice& dice) {
    const Precision all[] = {raster_precision(), ray_precision(),
                             RasterPrecision{.transform = Arithmetic::float64,
                                             .origin = Origin::eye,
                                             .subpixel_bits = 2,
                                             .depth_roundings = 400},
                             RasterPrecision{.transform = Arithmetic::float64, .depth_roundings = 9'000'000}};
    return all[dice.below(12) == 0 ? 3 : dice.below(3)];
}

/// Triangles of a few pixels along row 3, each around a pixel and leaning at random, some behind others'
/// backs or across near, some without area.
Scene small_triangles(Dice& dice, const View& view) {
    std::vector<Triangle> triangles;
    const double size = std::ldexp(1.0, dice.below(7) - 1), slope = std::ldexp(1.0, -dice.below(24));
    const double depth = std::ldexp(1.0, dice.below(11) - 2);
    for (int i = 0; i < 24; ++i) {
        const double x = dice.between(0, 64), y = dice.between(3, 4);
        const auto corner = [&] {
            const double lean = dice.below(9) == 0 ? 0 : slope * dice.between(-0.5, 0.5);
            return Corner{x + size * dice.between(-1, 1), y + size * dice.between(-1, 1), depth * (1 + lean)};
        };
        const Corner first = corner();
        triangles.push_back({first, corner(), dice.below(12) == 0 ? first : corner()});
    }
    return scene_of(view, triangles);
}

/// Near the ends of what is asked for or lawful, or at random within twice the bound, or nobody's depth.
float some_depth(Dice& dice, const DepthRow& bound, std::size_t i, double at_most) {
    constexpr float none[] = {std::numeric_limits<float>::quiet_NaN(), background_depth, -1, 0};
    if (dice.below(30) == 0) return none[dice.below(4)];
    const double shares[] = {at_most, 1, dice.between(0, 1.5), 0};
    const double either = dice.below(2) != 0 ? bound.low[i] : bound.high[i],
                 end = std::isfinite(either) ? either : 2 * bound.truth[i];
    const auto depth = float(bound.truth[i] + shares[dice.below(4)] * (end - bound.truth[i]));
    const int step = dice.below(3);
    return step == 0 ? depth : std::nextafter(depth, step == 1 ? 0.0f : 1e30f);
}

/// One renderer along a strip that shows some triangles; where it shows none its ratios are 0.
struct Side {
    Strip::Values<float> depth;
    Strip::Values<double> ratio;

    Side(Dice& dice, const Scene& scene, const Witness& witness, const Strip::Values<PrimitiveId>& shown,
         double at_most) {
        for (std::size_t first = 0; first < Strip::width; first += tile_columns)
            for (std::size_t i = first; i < first + tile_columns; ++i) {
                depth[i] = dice.below(9) != 0 ? background_depth : 1;
                ratio[i] = shown[i] == PrimitiveId::none && depth[i] == background_depth ? 0 : unsettled;
                if (std::size_t(shown[i]) >= scene.triangles.size()) continue;
                const DepthLaw law = depth_law_of(witness.triangle_in_view(shown[i]), witness.bounds());
                const auto held = [&](float z) {
                    TileRowOf<float> row;
                    row.fill(z);
                    return depths_in_row(law, Projection::perspective, {int(first), 3}, row);
                };
                depth[i] = some_depth(dice, held(1), i - first, at_most);
                ratio[i] = held(depth[i]).ratio[i - first];
            }
    }
};

/// Runs of a few pixels; some of nothing, and of ids that no triangle has.
Strip::Values<PrimitiveId> some_runs(Dice& dice, std::size_t triangle_count) {
    Strip::Values<PrimitiveId> shown;
    const int longest = 1 + dice.below(4);
    for (std::size_t i = 0; i < Strip::width; ++i) {
        shown[i] =
            i != 0 && dice.below(longest) != 0 ? shown[i - 1] : PrimitiveId(dice.below(int(triangle_count)));
        if (dice.below(30) == 0) shown[i] = dice.below(3) != 0 ? PrimitiveId::none : PrimitiveId(1 << 30);
    }
    return shown;
}

/// Two renderers that promise something, and show nothing.
struct Pair {
    const Frame frame;
    const Witness candidate, reference;
    const std::optional<strips::RunLens> lens;

    Pair(Dice& dice, const View& view, const Scene& scene)
        : frame({view.width, view.height}),
          candidate(scene, view, {frame, some_precision(dice)}),
          reference(scene, view, {frame, some_precision(dice)}),
          lens(run_lens_of(scene, candidate, reference)) {}
    Pair(const Pair&) = delete;  // the renderers look into its frame
    Pair& operator=(const Pair&) = delete;
};

struct Tried {
    int certain = 0, lawful = 0, bare = 0;
};

/// Holds a strip of the scene's triangles, shown at random, by every kernel.
void try_strip(Dice& dice, const View& view, const Scene& scene, Tried& tried) {
    const Pair pair(dice, view, scene);
    const auto& [frame, candidate, reference, lens] = pair;
    ASSERT_TRUE(lens);
    const AtMost at_most{dice.below(2) != 0 ? dice.between(0, 1) : 1,
                         dice.below(2) != 0 ? dice.between(0, 1) : 1};
    const Strip::Values<PrimitiveId> shown = some_runs(dice, scene.triangles.size());
    const Side ours(dice, scene, candidate, shown, at_most.candidate),
        theirs(dice, scene, reference, shown, at_most.reference);
    Strip strip{};
    strip.y = 3;
    strip.candidate.primitive = shown.data();
    strip.turns = strips::widest_kernel().compare(shown.data(), shown.data()).turns;
    strips::Runs runs;
    set_runs(scene, strip, runs);
    const auto certain_by = [&](const strips::Kernel& kernel) {
        return kernel.certain_by_corners({.x = 0,
                                          .y = 3,
                                          .primitive = shown.data(),
                                          .candidate = ours.depth.data(),
                                          .reference = theirs.depth.data(),
                                          .turns = strip.turns,
                                          .law_of_run = nullptr},
                                         runs, *pair.lens, at_most);
    };
    const Strip::Pixels certain = certain_by(strips::available_kernels().front());
    for (const strips::Kernel& kernel : strips::available_kernels())
        ASSERT_EQ(certain_by(kernel), certain) << kernel.name;
    for (std::size_t i = 0; i < Strip::width; ++i) {
        const bool is_lawful = ours.ratio[i] >= 0 && ours.ratio[i] <= at_most.candidate &&
                               theirs.ratio[i] >= 0 && theirs.ratio[i] <= at_most.reference;
        tried.lawful += is_lawful;
        if ((certain >> i & 1) == 0) continue;
        ++tried.certain, tried.bare += shown[i] == PrimitiveId::none;
        ASSERT_TRUE(is_lawful) << i << ": " << ours.depth[i] << " has " << ours.ratio[i] << " of "
                               << at_most.candidate << ", " << theirs.depth[i] << " has " << theirs.ratio[i]
                               << " of " << at_most.reference;
    }
}

/// By every kernel alike.
std::vector<DepthTolerance> tolerances_by_all(const strips::RunLens& lens, const Scene& scene,
                                              const PixelBox& tile) {
    std::vector<PrimitiveId> ids;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) ids.push_back(PrimitiveId(i));
    std::vector<DepthTolerance> expected(ids.size());
    set_tolerances(strips::available_kernels().front(), lens, scene, {ids, tile}, expected);
    using Bits = std::array<std::uint64_t, sizeof(DepthTolerance) / sizeof(double)>;
    for (const strips::Kernel& kernel : strips::available_kernels()) {
        std::vector<DepthTolerance> tolerances(ids.size());
        set_tolerances(kernel, lens, scene, {ids, tile}, tolerances);
        for (std::size_t i = 0; i < ids.size(); ++i) {
            if (expected[i].least <= expected[i].most)
                EXPECT_EQ(std::bit_cast<Bits>(tolerances[i]), std::bit_cast<Bits>(expected[i]))
                    << kernel.name;
            else
                EXPECT_GT(tolerances[i].least, tolerances[i].most) << kernel.name;
        }
    }
    return expected;
}

/// Holds depths of each of the scene's triangles by its tolerance in a tile.
void try_tolerances(Dice& dice, const View& view, const Scene& scene, Tried& tried) {
    const Pair pair(dice, view, scene);
    const auto& [frame, candidate, reference, lens] = pair;
    ASSERT_TRUE(lens);
    const bool is_row = dice.below(2) != 0;
    const PixelBox tile{0, is_row ? 3 : 0, is_row ? 16 : 64, is_row ? 4 : 8};
    const std::vector<DepthTolerance> tolerances = tolerances_by_all(*lens, scene, tile);
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        Strip::Values<PrimitiveId> shown;
        shown.fill(PrimitiveId(t));
        const AtMost at_most{dice.below(2) != 0 ? dice.between(0, 1) : 1,
                             dice.below(2) != 0 ? dice.between(0, 1) : 1};
        const Side ours(dice, scene, candidate, shown, at_most.candidate),
            theirs(dice, scene, reference, shown, at_most.reference);
        for (int i = 0; i < tile.right; ++i) {
            const int first = i / int(tile_columns) * int(tile_columns), column = i - first;
            const auto& [a, b] = certain_depths(
                tolerances[t], nullptr, Projection::perspective,
                {{first, 3}, &ours.depth[std::size_t(first)], &theirs.depth[std::size_t(first)]}, at_most);
            const double our_ratio = ours.ratio[std::size_t(i)], their_ratio = theirs.ratio[std::size_t(i)];
            tried.lawful += our_ratio >= 0 && our_ratio <= at_most.candidate;
            tried.certain += int(a >> column & 1);
            ASSERT_TRUE((a >> column & 1) == 0 || (our_ratio >= 0 && our_ratio <= at_most.candidate)) << t;
            ASSERT_TRUE((b >> column & 1) == 0 || (their_ratio >= 0 && their_ratio <= at_most.reference))
                << t;
        }
    }
}

TEST(RunLens, HasTolerancesOfLawfulDepths) {
    Tried small, any;
    for (std::uint32_t seed = 0; seed < 1500; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(Projection::perspective, 64, 8);
        try_tolerances(dice, view, small_triangles(dice, view), small);
        const Surroundings s = random_surroundings(seed);
        if (s.view.camera.projection == Projection::perspective) try_tolerances(dice, s.view, s.scene, any);
        if (HasFailure()) return;
    }
    EXPECT_GT(small.certain, small.lawful / 8) << "of pixels that are mostly beside them";
    EXPECT_GT(any.certain, any.lawful / 8);
}

TEST(RunLens, IsCertainOfSmallTrianglesLawfulDepths) {
    Tried tried;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const View view = pixel_view(Projection::perspective, 64, 8);
        try_strip(dice, view, small_triangles(dice, view), tried);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tried.certain, tried.lawful / 4);
    EXPECT_GT(tried.bare, 2000);
}

TEST(RunLens, IsCertainOfLawfulDepthsOfAnyTriangles) {
    Tried tried;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        if (s.view.camera.projection != Projection::perspective) continue;
        Dice dice(seed);
        try_strip(dice, s.view, s.scene, tried);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(tried.certain, tried.lawful / 8);
}

TEST(RunLens, IsOfPerspectivesAndTermsThatHoldForEveryTriangle) {
    const auto has_lens = [](Projection projection, const Precision& precision) {
        const View view = pixel_view(projection, 4, 4);
        const Scene scene = scene_of(view, {wall(4)});
        const Frame frame({4, 4});
        return run_lens_of(scene, Witness(scene, view, {frame, precision}),
                           Witness(scene, view, {frame, ray_precision()}))
            .has_value();
    };
    EXPECT_TRUE(has_lens(Projection::perspective, raster_precision()));
    EXPECT_FALSE(has_lens(Projection::parallel, raster_precision()));
    EXPECT_FALSE(has_lens(Projection::perspective, RasterPrecision{}));
    EXPECT_FALSE(has_lens(Projection::perspective, PlaneRayPrecision{}));
}

}  // namespace
}  // namespace zproof
