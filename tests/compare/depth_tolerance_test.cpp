/// What a tolerance calls certain must be what the whole formula finds.
#include "compare/bounds/depth_tolerance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

#include "compare/first_pass/held_depths.h"
#include "compare/strips/certain_depths.h"
#include "compare/strips/dispatch.h"
#include "compare/truth/depth_bound.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

/// A depth near the ends of what is asked for or lawful, or at random within twice the bound, or none at all.
float some_depth(Dice& dice, const DepthBound& bound, double at_most) {
    constexpr float none[] = {std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity(),
                              -1,
                              0,
                              std::numeric_limits<float>::max(),
                              1e-40f};
    if (dice.below(20) == 0) return none[dice.below(6)];
    const bool nearer = dice.below(2) != 0;
    const double shares[] = {at_most, 1, dice.between(0, 2), 0};
    const double end = nearer ? bound.low : bound.high;
    const auto depth = float(bound.truth + shares[dice.below(4)] * (end - bound.truth));
    const int step = dice.below(3);
    return step == 0 ? depth : std::nextafter(depth, step == 1 ? 0.0f : 1e30f);
}

struct Side {
    RowPlace at;
    DepthLaw law;
    TriangleDepth depth;
    TileRowOf<float> z;

    Side(const View& view, const Precision& precision, const CornersWorld& p, const RowPlace& row)
        : at(row),
          law(depth_law_of(TriangleInView(view, ViewBounds(view, precision), p),
                           ViewBounds(view, precision))),
          depth(depth_of(TriangleInView(view, ViewBounds(view, precision), p), ViewBounds(view, precision))),
          z{} {}

    void set_depths(Dice& dice, double at_most) {
        for (std::size_t i = 0; i < tile_columns; ++i)
            z[i] = some_depth(dice, depth.at(at.left + int(i), at.y), at_most);
    }
};

struct Tried {
    int certain = 0, lawful = 0;
};

/// Counts what is certain of depths z, all of which must be so.
void try_row(ColumnMask certain, const DepthRow& exact, const TileRowOf<float>& z, double at_most,
             Tried& tried) {
    for (std::size_t i = 0; i < tile_columns; ++i) {
        tried.lawful += exact.ratio[i] >= 0 && exact.ratio[i] <= at_most;
        if ((certain >> i & 1) == 0) continue;
        ++tried.certain;
        ASSERT_GE(exact.ratio[i], 0) << z[i];
        ASSERT_LE(exact.ratio[i], at_most) << z[i];
    }
}
void try_side(ColumnMask certain, const Side& side, Projection projection, double at_most, Tried& tried) {
    try_row(certain, depths_in_row(side.law, projection, side.at, side.z), side.z, at_most, tried);
}

/// The row by itself, or with others above, below and beside it.
PixelBox part_around(Dice& dice, const RowPlace& row) {
    const int left = row.left - dice.below(20), top = row.y - dice.below(8);
    if (dice.below(2) != 0) return {row.left, row.y, row.left + int(tile_columns), row.y + 1};
    return {left, top, row.left + int(tile_columns) + dice.below(20), row.y + 1 + dice.below(8)};
}

/// Nobody says what holds next to corners.
constexpr const CornerTolerance* no_corners = nullptr;

TEST(DepthTolerance, IsOfLawfulDepthsThatErrNoMore) {
    Tried ours, theirs;
    int usable = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        const Precision precisions[] = {RasterPrecision{},
                                        RayPrecision{},
                                        PlaneRayPrecision{},
                                        RasterPrecision{.subpixel_bits = 4, .depth_roundings = 5},
                                        RasterPrecision{.subpixel_bits = 0, .depth_roundings = 4000},
                                        RasterPrecision{.depth_buffer = DepthBuffer::reversed_z}};
        const Projection projection = s.view.camera.projection;
        for (const Neighbour& n : s.around.neighbours) {
            const RowPlace at{0, s.y};
            Side candidate(s.view, precisions[dice.below(6)], n.p_world, at),
                reference(s.view, precisions[dice.below(6)], n.p_world, at);
            const AtMost at_most{dice.below(2) != 0 ? dice.between(0, 1) : 1,
                                 dice.below(2) != 0 ? dice.between(0, 0.1) : 1};
            candidate.set_depths(dice, at_most.candidate);
            reference.set_depths(dice, at_most.reference);
            const PixelBox part = part_around(dice, at);
            const auto [far_off, next_to_corners] =
                tolerances_of(candidate.law, reference.law, projection, part);
            ++asked, usable += far_off.least <= far_off.most;
            for (const CornerTolerance* const corners : {no_corners, &next_to_corners}) {
                const ColumnsOfBoth certain = certain_depths(
                    far_off, corners, projection, {at, candidate.z.data(), reference.z.data()}, at_most);
                try_side(certain.candidate, candidate, projection, at_most.candidate, ours);
                try_side(certain.reference, reference, projection, at_most.reference, theirs);
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_GT(usable, asked / 4);
    EXPECT_GT(ours.certain, ours.lawful / 4);
    EXPECT_GT(theirs.certain, theirs.lawful / 4);
}

/// A wall at depth 4 whose depth may be off by `absolute` and by the share `relative`, seen along an axis.
DepthLaw wall_law(double absolute, double relative, Projection projection) {
    DepthLaw law{};
    law.nearness_offset = projection == Projection::perspective ? 0.25 : -4;
    law.least = law.highest = 0.25;
    law.amplification = 1;
    law.depth_factor = relative / (1 + relative);
    law.relative = relative;
    law.absolute = absolute;
    law.nearest = law.farthest = 4;
    return law;
}

constexpr PixelBox a_row{0, 0, int(tile_columns), 1};

/// Bounds that reach behind the viewer, and beyond twice the depth.
TEST(DepthTolerance, HoldsOfWideBounds) {
    Tried tried;
    Dice dice(1);
    for (int round = 0; round < 20'000; ++round) {
        SCOPED_TRACE(round);
        const Projection projection = dice.below(2) != 0 ? Projection::perspective : Projection::parallel;
        const double absolute = std::ldexp(1.0, dice.below(30) - 26),
                     relative = std::ldexp(1.0, dice.below(30) - 26);
        DepthLaw law = wall_law(absolute, relative, projection);
        law.own_error = std::ldexp(dice.between(0, 1), -20 - dice.below(30));
        if (dice.below(2) != 0) {
            law.gradient = 1;  // however small the steps from pixel to pixel are
            law.base = law.most = std::ldexp(dice.between(0, 1), -dice.below(20));
            law.least = 0.125, law.highest = 0.5, law.nearest = 2, law.farthest = 8;
            if (dice.below(2) != 0)
                law.nearest = -std::numeric_limits<double>::infinity(), law.farthest = -law.nearest;
        }
        TileRowOf<float> z;
        for (float& depth : z) depth = float(4 + std::ldexp(dice.between(-1, 1), dice.below(30) - 25));
        const DepthRow exact = depths_in_row(law, projection, {0, 0}, z);
        const double at_most = dice.below(2) != 0 ? 1 : dice.between(0, 1);
        const auto [far_off, next_to_corners] = tolerances_of(law, law, projection, a_row);
        for (const CornerTolerance* const corners : {no_corners, &next_to_corners}) {
            const ColumnMask certain =
                certain_depths(far_off, corners, projection, {{0, 0}, z.data(), z.data()}, {at_most, at_most})
                    .candidate;
            try_row(certain, exact, z, at_most, tried);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(tried.certain, tried.lawful / 2);
}

/// Whoever has an error that is nearly the largest has it found nearly everywhere.
TEST(DepthTolerance, OfAWallIsNearlyItsBound) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const DepthLaw law = wall_law(0x1p-20, 0x1p-23, projection);
        TileRowOf<float> z;
        for (std::size_t i = 0; i < tile_columns; ++i) z[i] = 4 + float(i) * 0x1p-22f;
        const auto [far_off, next_to_corners] = tolerances_of(law, law, projection, a_row);
        const ColumnsOfBoth certain =
            certain_depths(far_off, &next_to_corners, projection, {{0, 0}, z.data(), z.data()}, {1, 0.5});
        const DepthRow exact = depths_in_row(law, projection, {0, 0}, z);
        ColumnMask lawful = 0, half = 0;
        for (std::size_t i = 0; i < tile_columns; ++i) {
            lawful |= ColumnMask(exact.ratio[i] >= 0 && exact.ratio[i] < 0.999) << i;
            half |= ColumnMask(exact.ratio[i] >= 0 && exact.ratio[i] < 0.499) << i;
        }
        EXPECT_NE(lawful, half);
        EXPECT_EQ(certain.candidate, lawful);
        EXPECT_EQ(certain.reference, half);
    }
}

TEST(DepthTolerance, SaysNothingBeyondItsPart) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        DepthLaw law = wall_law(0x1p-20, 0x1p-10, projection);
        const double sign = projection == Projection::perspective ? 1 : -1;
        law.nearness_per_x = sign * 0x1p-8;
        law.least = 0x1p-6, law.highest = 16, law.nearest = 0x1p-4, law.farthest = 64;
        TileRowOf<float> z;
        for (std::size_t i = 0; i < tile_columns; ++i) {
            const double nearness = law.nearness_offset + law.nearness_per_x * double(i);
            z[i] = float(projection == Projection::perspective ? 1 / nearness : -nearness);
        }
        const PixelBox part{4, 0, 8, 1};
        const auto [far_off, next_to_corners] = tolerances_of(law, law, projection, part);
        for (const CornerTolerance* const corners : {no_corners, &next_to_corners}) {
            const ColumnsOfBoth certain =
                certain_depths(far_off, corners, projection, {{0, 0}, z.data(), z.data()}, {});
            EXPECT_EQ(certain.candidate, 0xf0u);
            EXPECT_EQ(certain.reference, 0xf0u);
        }
    }
}

/// Of a triangle that leans a little, near depth 4 in the strip from pixel (64, 3) on.
Tolerances some_tolerances(Dice& dice, Projection projection) {
    const bool perspective = projection == Projection::perspective;
    const double w = perspective ? 0.25 : 4, step = w * 0x1p-26, error = perspective ? 0x1p-22 : 0x1p-20;
    Tolerances both;
    DepthTolerance& t = both.far_off;
    CornerTolerance& c = both.next_to_corners;
    t.w_per_x = dice.between(-step, step);
    t.w_per_y = dice.between(-step, step);
    t.w_offset = w - 96 * t.w_per_x - 3 * t.w_per_y;
    t.unsure = 0x1p-10 * error;
    c.least = w - dice.between(0, 64) * step;
    c.most = w + dice.between(0, 64) * step;
    c.corner_least = c.least - dice.between(0, 9) * step;
    c.corner_most = c.most + dice.between(0, 9) * step;
    c.largest = 0.5 * (perspective ? 1 : w);
    const auto set_some = [&](DepthTolerance::Bound& far_off, CornerTolerance::Bound& there) {
        there.at_corners = dice.between(1, 8) * error;
        there.shift = dice.below(2) != 0 ? dice.between(0, 32) * step : 0;
        there.per_shift = there.shift > 0 ? dice.between(0, 8) * error / there.shift : 0;
        far_off.room = there.at_corners + there.per_shift * there.shift;
        there.own = far_off.room * dice.between(0, 1);
        far_off.lawful = std::min(far_off.room - there.own - t.unsure, c.largest);
    };
    set_some(t.candidate, c.candidate);
    set_some(t.reference, c.reference);
    const double away = std::max(c.candidate.shift, c.reference.shift);
    t.least = std::max(c.least, c.corner_least + away);
    t.most = std::min(c.most, c.corner_most - away);
    return both;
}

/// Of three laws, the first of which says nothing; and whether it is told what holds next to corners.
struct SomeTolerances {
    std::array<DepthTolerance, 3> far_off{tolerance_of_nothing};
    std::array<CornerTolerance, 3> next_to_corners{corner_tolerance_of_nothing};
    bool tells_corners;
    Projection projection;

    explicit SomeTolerances(Dice& dice)
        : tells_corners(dice.below(2) != 0),
          projection(dice.below(2) != 0 ? Projection::perspective : Projection::parallel) {
        for (std::size_t law = 1; law < far_off.size(); ++law)
            std::tie(far_off[law], next_to_corners[law]) = as_tuple(some_tolerances(dice, projection));
    }
    const CornerTolerance* corners(std::size_t law) const {
        return tells_corners ? &next_to_corners[law] : nullptr;
    }
    strips::Tolerated tolerated(const AtMost& at_most) const {
        return {far_off.data(), tells_corners ? next_to_corners.data() : nullptr, projection,
                at_most.candidate, at_most.reference};
    }

  private:
    static std::tuple<DepthTolerance, CornerTolerance> as_tuple(const Tolerances& both) {
        return {both.far_off, both.next_to_corners};
    }
};

/// A strip in which each pixel shows one of a few triangles, nothing or an id of no triangle.
struct FewTriangles {
    Strip::Values<std::uint32_t> law, law_of_run{};
    Strip::Values<PrimitiveId> primitive;
    Strip::Values<float> our_depth, their_depth;
    Strip::Pixels turns = 0;

    explicit FewTriangles(Dice& dice) {
        const int longest = 1 + dice.below(90);
        const double off = dice.below(3) == 0 ? 0.2 : 4;
        std::size_t runs = 0;
        for (std::size_t i = 0; i < Strip::width; ++i) {
            const bool turns_here = i == 0 || dice.below(longest) == 0;
            turns |= Strip::Pixels{turns_here} << i;
            if (turns_here) law_of_run[runs++] = std::uint32_t(dice.below(3));
            law[i] = law_of_run[runs - 1];
            primitive[i] = !turns_here     ? primitive[i - 1]
                           : law[i] != 0   ? PrimitiveId(law[i])
                           : dice.below(3) ? PrimitiveId::none
                                           : PrimitiveId(9);
            our_depth[i] = float(4 + dice.between(-off, off) * 0x1p-20);
            their_depth[i] = float(4 + dice.between(-off, off) * 0x1p-20);
            if (law[i] == 0 && dice.below(9) != 0) our_depth[i] = background_depth;
            if (law[i] == 0 && dice.below(9) != 0) their_depth[i] = background_depth;
        }
        if (dice.below(4) == 0) our_depth[std::size_t(dice.below(64))] = std::nanf("");
        if (dice.below(4) == 0) their_depth[std::size_t(dice.below(64))] = background_depth;
    }
};

TEST(StripKernels, FindTheDepthsCertainOfEachTriangleByItself) {
    std::array<int, 3> found{};  // not certain, certain, a whole strip
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const SomeTolerances tolerances(dice);
        const FewTriangles shown(dice);
        const Strip::Pixels asked =
            dice.below(2) != 0 ? Strip::all : Strip::Pixels{0xF0FFF0} << dice.below(48);
        const AtMost at_most{1, dice.below(2) != 0 ? 1 : 0.5};
        Strip::Pixels expected = 0;
        for (std::size_t i = 0; i < Strip::width; ++i) {
            const std::size_t first = i / tile_columns * tile_columns;
            const auto [a, b] = certain_depths(
                tolerances.far_off[shown.law[i]], tolerances.corners(shown.law[i]), tolerances.projection,
                {{64 + int(first), 3}, &shown.our_depth[first], &shown.their_depth[first]}, at_most);
            const bool is_bare = shown.primitive[i] == PrimitiveId::none &&
                                 shown.our_depth[i] == background_depth &&
                                 shown.their_depth[i] == background_depth;
            expected |= Strip::Pixels{is_bare || (a & b & 1u << (i - first)) != 0} << i;
        }
        for (const strips::Kernel& kernel : strips::available_kernels()) {
            const Strip::Pixels certain = kernel.certain({.x = 64,
                                                          .y = 3,
                                                          .primitive = shown.primitive.data(),
                                                          .candidate = shown.our_depth.data(),
                                                          .reference = shown.their_depth.data(),
                                                          .turns = shown.turns,
                                                          .asked = asked,
                                                          .law_of_run = shown.law_of_run.data()},
                                                         tolerances.tolerated(at_most));
            ASSERT_EQ(certain, expected & asked) << kernel.name;
        }
        found[1] += std::popcount(expected);
        found[0] += std::popcount(~expected);
        found[2] += ~expected == 0;
    }
    EXPECT_GT(found[0], 20'000);
    EXPECT_GT(found[1], 20'000);
    EXPECT_GT(found[2], 50);
}

/// Triangles that a strip shows, each at some of its pixels.
Strip::ShownOnes some_of(Dice& dice, const Strip::Values<std::uint32_t>& law) {
    Strip::ShownOnes shown;
    for (std::uint32_t of = 0; of < 3; ++of) {
        Strip::Pixels pixels = 0;
        for (std::size_t i = 0; i < Strip::width; ++i)
            pixels |= Strip::Pixels{law[i] == of && dice.below(3) != 0} << i;
        if (pixels != 0) shown.of[std::size_t(shown.count++)] = {of, pixels};
    }
    return shown;
}

TEST(StripKernels, FindTheDepthsOfOneFrameLawful) {
    std::array<int, 2> found{};
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        Dice dice(seed);
        const SomeTolerances tolerances(dice);
        const FewTriangles strip(dice);
        const Strip::ShownOnes shown = some_of(dice, strip.law);
        const bool is_ours = dice.below(2) != 0;
        const float* const depths = is_ours ? strip.our_depth.data() : strip.their_depth.data();
        Strip::Pixels expected = 0, asked = 0;
        for (const auto& [law, pixels] : std::span(shown.of.data(), std::size_t(shown.count)))
            for (std::size_t first = 0; first < Strip::width; first += Strip::chunk) {
                const auto [ours, theirs] =
                    certain_depths(tolerances.far_off[law], tolerances.corners(law), tolerances.projection,
                                   {{64 + int(first), 3}, depths + first, depths + first}, {});
                expected |= pixels & Strip::Pixels{is_ours ? ours : theirs} << first;
                asked |= pixels;
            }
        for (const strips::Kernel& kernel : strips::available_kernels()) {
            const Strip::Pixels lawful =
                kernel.lawful({64, 3, depths, shown.of.data(), shown.count,
                               is_ours ? &DepthTolerance::candidate : &DepthTolerance::reference,
                               is_ours ? &CornerTolerance::candidate : &CornerTolerance::reference},
                              tolerances.tolerated({}));
            ASSERT_EQ(lawful, expected) << kernel.name;
        }
        found[0] += std::popcount(asked & ~expected);
        found[1] += std::popcount(expected);
    }
    EXPECT_GT(found[0], 20'000);
    EXPECT_GT(found[1], 20'000);
}

}  // namespace
}  // namespace zproof
