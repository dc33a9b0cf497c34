/// What single precision calls certain must be what double precision finds.
#include "compare/depth_bins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/depth_bound.h"
#include "random_surroundings.h"

namespace zproof {
namespace {

/// As BoundHistogram has it.
std::int32_t bin_of(double ratio) { return std::int32_t(std::min(ratio * 20, 20.0)); }

/// A depth near the ends of a bin, or at random within twice the bound, or none at all.
float some_depth(Dice& dice, const DepthBound& bound) {
    constexpr float none[] = {std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::infinity(),
                              -1,
                              0,
                              std::numeric_limits<float>::max(),
                              1e-40f};
    if (dice.below(20) == 0) return none[dice.below(6)];
    const bool nearer = dice.below(2) != 0;
    const double share = dice.below(2) ? dice.below(22) / 20.0 : dice.between(0, 2);
    const double end = nearer ? bound.low : bound.high;
    const auto depth = float(bound.truth + share * (end - bound.truth));
    const int step = dice.below(3);
    return step == 0 ? depth : std::nextafter(depth, step == 1 ? 0.0f : 1e30f);
}

struct Side {
    RowPlace at;
    DepthLaw law;
    TriangleDepth depth;
    TileRowOf<float> z;

    Side(Dice& dice, const View& view, const Precision& precision, const CornersWorld& p, const RowPlace& row)
        : at(row),
          law(depth_law_of(TriangleInView(view, ViewBounds(view, precision), p),
                           ViewBounds(view, precision))),
          depth(depth_of(TriangleInView(view, ViewBounds(view, precision), p), ViewBounds(view, precision))) {
        for (std::size_t i = 0; i < tile_columns; ++i)
            z[i] = some_depth(dice, depth.at(row.left + int(i), row.y));
    }
};

struct Tried {
    int certain = 0, lawful = 0;
};

/// Counts what is certain, all of which must be so.
void try_side(const EstimatedRow::Side& estimated, const Side& side, Projection projection, double largest,
              Tried& tried) {
    const DepthRow exact = depths_in_row(side.law, projection, side.at, side.z);
    for (std::size_t i = 0; i < tile_columns; ++i) {
        tried.lawful += exact.ratio[i] >= 0;
        if ((estimated.certain >> i & 1) == 0) continue;
        ++tried.certain;
        ASSERT_GE(exact.ratio[i], 0) << side.z[i];
        ASSERT_EQ(estimated.bin[i], bin_of(exact.ratio[i])) << side.z[i] << " " << exact.ratio[i];
        ASSERT_TRUE((estimated.may_exceed >> i & 1) != 0 || exact.ratio[i] <= largest) << side.z[i];
    }
}

/// Rounded down.
KnownLargest known_of(double largest) {
    const auto known = float(20 * largest * (1 - 0x1p-20));
    return {known, known};
}

TEST(DepthEstimate, IsCertainOnlyOfTheRightBin) {
    Tried ours, theirs;
    int usable = 0, asked = 0;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        const Precision precisions[] = {RasterPrecision{}, RayPrecision{}, PlaneRayPrecision{},
                                        RasterPrecision{.subpixel_bits = 4, .depth_roundings = 5},
                                        RasterPrecision{.depth_buffer = DepthBuffer::reversed_z}};
        const Projection projection = s.view.camera.projection;
        for (const Neighbour& n : s.around.neighbours) {
            const RowPlace at{0, s.y};
            const Side candidate(dice, s.view, precisions[dice.below(5)], n.p_world, at),
                reference(dice, s.view, precisions[dice.below(5)], n.p_world, at);
            const double largest = dice.between(0, 1);
            const KnownLargest known = known_of(largest);
            const DepthEstimate triangle = estimate_of(candidate.law, reference.law, projection, known);
            ++asked, usable += triangle.is_usable;
            if (!triangle.is_usable) continue;
            EstimatedRow row;
            estimate(triangle, {projection, known}, {at, candidate.z.data(), reference.z.data()}, row);
            try_side(row.candidate, candidate, projection, largest, ours);
            try_side(row.reference, reference, projection, largest, theirs);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(usable, asked / 4);
    EXPECT_GT(ours.certain, ours.lawful / 4);
    EXPECT_GT(theirs.certain, theirs.lawful / 4);
}

/// All depths are off by that share of their bounds, this way or that, to the nearest float.
void set_depths(Dice& dice, double share, Side& side) {
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const DepthBound bound = side.depth.at(side.at.left + int(i), side.at.y);
        side.z[i] = float(bound.truth + share * ((dice.below(2) ? bound.low : bound.high) - bound.truth));
    }
}

/// Errors about as large as the first bin is wide, and as the largest known: quiet ones are less than both.
TEST(DepthEstimate, IsQuietOnlyOfTheFirstBin) {
    int quiet[2] = {}, loud = 0;
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        Dice dice(seed);
        const Precision precisions[] = {RasterPrecision{}, RayPrecision{}, PlaneRayPrecision{}};
        const Projection projection = s.view.camera.projection;
        for (const Neighbour& n : s.around.neighbours) {
            const RowPlace at{0, s.y};
            Side candidate(dice, s.view, precisions[dice.below(3)], n.p_world, at),
                reference(dice, s.view, precisions[dice.below(3)], n.p_world, at);
            const double largest = dice.below(2) ? dice.between(0.02, 0.06) : 1;
            set_depths(dice, dice.between(0, 0.06), candidate);
            set_depths(dice, dice.between(0, 0.06), reference);
            const KnownLargest known = known_of(largest);
            const DepthEstimate triangle = estimate_of(candidate.law, reference.law, projection, known);
            if (!triangle.is_usable) continue;
            EstimatedRow row;
            estimate(triangle, {projection, known}, {at, candidate.z.data(), reference.z.data()}, row);
            const auto look = [&](const EstimatedRow::Side& estimated, const Side& side) {
                Tried tried;
                try_side(estimated, side, projection, largest, tried);
                ++(estimated.is_quiet ? quiet[projection == Projection::parallel] : loud);
                if (!estimated.is_quiet) return;
                EXPECT_EQ(tried.certain, int(tile_columns));
                EXPECT_EQ(estimated.bin, TileRowOf<std::int32_t>{});
                EXPECT_EQ(estimated.may_exceed, 0u);
            };
            look(row.candidate, candidate);
            look(row.reference, reference);
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(quiet[0], 500);
    EXPECT_GT(quiet[1], 100);
    EXPECT_GT(loud, 1000);
}

/// A wall at depth 4 whose depth may be off by `absolute`, seen along an axis.
DepthLaw wall_law(double absolute, Projection projection) {
    DepthLaw law{};
    law.nearness_offset = projection == Projection::perspective ? 0.25 : -4;
    law.least = law.highest = 0.25;
    law.amplification = 1;
    law.depth_factor = law.relative = 0x1p-23;
    law.absolute = absolute;
    law.nearest = law.farthest = 4;
    return law;
}

/// Of pixels that nobody asks about it does not matter how large they are.
TEST(DepthEstimate, IsQuietWhereItIsAsked) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const DepthLaw law = wall_law(0x1p-20, projection);
        const KnownLargest known{20, 20};
        TileRowOf<float> z;
        z.fill(4);
        z[3] = 5, z[9] = std::numeric_limits<float>::quiet_NaN();
        const auto is_quiet = [&](ColumnMask asked) {
            EstimatedRow row;
            const DepthEstimate wall = estimate_of(law, law, projection, known);
            estimate(wall, {projection, known, asked}, {{0, 0}, z.data(), z.data()}, row);
            return row.candidate.is_quiet && row.reference.is_quiet;
        };
        EXPECT_FALSE(is_quiet(all_columns));
        EXPECT_FALSE(is_quiet(all_columns & ~8u));
        EXPECT_FALSE(is_quiet(all_columns & ~(1u << 9)));
        EXPECT_TRUE(is_quiet(all_columns & ~(8u | 1u << 9)));
    }
}

/// The column of one is that of the other, as far as anything is certain of it.
void expect_same(const EstimatedRow::Side& a, const EstimatedRow::Side& b, std::size_t column) {
    ASSERT_EQ(a.certain >> column & 1, b.certain >> column & 1);
    if ((a.certain >> column & 1) == 0) return;
    ASSERT_EQ(a.bin[column], b.bin[column]);
    ASSERT_EQ(a.may_exceed >> column & 1, b.may_exceed >> column & 1);
}

TEST(DepthEstimate, OfTrianglesSideBySideIsThatOfEach) {
    int certain = 0, unusable = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        const Surroundings s = random_surroundings(seed);
        if (s.around.neighbours.empty()) continue;
        Dice dice(seed);
        const Projection projection = s.view.camera.projection;
        const RowPlace at{0, s.y};
        std::vector<DepthEstimate> estimates;
        std::vector<Side> sides;
        for (const Neighbour& n : s.around.neighbours) {
            const Side candidate(dice, s.view, RasterPrecision{}, n.p_world, at),
                reference(dice, s.view, RayPrecision{}, n.p_world, at);
            estimates.push_back(estimate_of(candidate.law, reference.law, projection, {5, 5}));
            sides.push_back(dice.below(2) ? candidate : reference);
        }
        const bool are_same = dice.below(3) == 0;
        Estimates ours, theirs;
        TileRowOf<float> our_depth, their_depth;
        for (std::size_t i = 0; i < tile_columns; ++i) {
            const auto one = std::size_t(dice.below(int(sides.size())));
            const auto other = are_same ? one : std::size_t(dice.below(int(sides.size())));
            ours[i] = &estimates[one], theirs[i] = &estimates[other];
            our_depth[i] = sides[one].z[i], their_depth[i] = sides[other].z[i];
        }
        const DepthsOfBoth depths{at, our_depth.data(), their_depth.data()};
        const Asked asked{.projection = projection,
                          .known = {5, 5},
                          .may_be_quiet = {dice.below(2) != 0, dice.below(2) != 0}};
        EstimatedRow together;
        if (are_same)
            estimate({ours, ours}, asked, depths, together);
        else
            estimate({ours, theirs}, asked, depths, together);
        for (std::size_t i = 0; i < tile_columns; ++i) {
            EstimatedRow alone, other_alone;
            estimate(*ours[i], asked, depths, alone);
            estimate(*theirs[i], asked, depths, other_alone);
            expect_same(together.candidate, alone.candidate, i);
            expect_same(together.reference, other_alone.reference, i);
            certain += int(together.candidate.certain >> i & 1);
            if (!ours[i]->is_usable) {
                ++unusable;
                ASSERT_EQ(together.candidate.certain >> i & 1, 0u);
            }
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(certain, 3000);
    EXPECT_GT(unusable, 300);
}

TEST(DepthEstimate, LeavesBoundsThatReachBehindTheViewer) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const DepthLaw near = wall_law(0x1p-20, projection), far = wall_law(8, projection);
        EXPECT_TRUE(estimate_of(near, near, projection, {}).is_usable);
        EXPECT_FALSE(estimate_of(near, far, projection, {}).is_usable);
        EXPECT_FALSE(estimate_of(far, near, projection, {}).is_usable);
    }
}

TEST(DepthEstimate, KnowsTheBinsOfAWall) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const DepthLaw law = wall_law(0x1p-20, projection);
        TileRowOf<float> z;
        for (std::size_t i = 0; i < tile_columns; ++i) z[i] = 4 + float(i) * 0x1p-22f;
        EstimatedRow row;
        const KnownLargest known{20, 20};
        estimate(estimate_of(law, law, projection, known), {projection, known}, {{0, 0}, z.data(), z.data()},
                 row);
        const DepthRow exact = depths_in_row(law, projection, {0, 0}, z);
        ColumnMask lawful = 0;
        for (std::size_t i = 0; i < tile_columns; ++i)
            lawful |= ColumnMask(exact.ratio[i] >= 0 && exact.ratio[i] < 0.99) << i;
        EXPECT_GT(lawful, 0u);
        EXPECT_EQ(row.candidate.certain & lawful, lawful);
        EXPECT_EQ(row.candidate.may_exceed & lawful, 0u);
    }
}

}  // namespace
}  // namespace zproof
