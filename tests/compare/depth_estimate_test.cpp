/// What single precision calls certain must be what double precision finds.
#include "compare/depth_estimate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/depth_bound.h"
#include "compare/estimate_row.h"
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
            const DepthEstimate estimate = estimate_of(candidate.law, reference.law, projection);
            ++asked, usable += estimate.is_usable;
            if (!estimate.is_usable) continue;
            const double largest = dice.between(0, 1);
            const auto known = float(20 * largest * (1 - 0x1p-20));
            EstimatedRow row;
            zproof::estimate(estimate, projection, {at, candidate.z.data(), reference.z.data()},
                             {known, known}, row);
            try_side(row.candidate, candidate, projection, largest, ours);
            try_side(row.reference, reference, projection, largest, theirs);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(usable, asked / 4);
    EXPECT_GT(ours.certain, ours.lawful / 4);
    EXPECT_GT(theirs.certain, theirs.lawful / 4);
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
            estimates.push_back(estimate_of(candidate.law, reference.law, projection));
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
        EstimateRow row;
        put_side_by_side(projection, ours, theirs, row);
        const DepthsOfBoth depths{at, our_depth.data(), their_depth.data()};
        EstimatedRow together;
        estimate(row, projection, depths, {5, 5}, together);
        for (std::size_t i = 0; i < tile_columns; ++i) {
            EstimatedRow alone, other_alone;
            estimate(*ours[i], projection, depths, {5, 5}, alone);
            estimate(*theirs[i], projection, depths, {5, 5}, other_alone);
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

TEST(DepthEstimate, LeavesBoundsThatReachBehindTheViewer) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const DepthLaw near = wall_law(0x1p-20, projection), far = wall_law(8, projection);
        EXPECT_TRUE(estimate_of(near, near, projection).is_usable);
        EXPECT_FALSE(estimate_of(near, far, projection).is_usable);
        EXPECT_FALSE(estimate_of(far, near, projection).is_usable);
    }
}

TEST(DepthEstimate, KnowsTheBinsOfAWall) {
    for (const Projection projection : {Projection::perspective, Projection::parallel}) {
        const DepthLaw law = wall_law(0x1p-20, projection);
        TileRowOf<float> z;
        for (std::size_t i = 0; i < tile_columns; ++i) z[i] = 4 + float(i) * 0x1p-22f;
        EstimatedRow row;
        estimate(estimate_of(law, law, projection), projection, {{0, 0}, z.data(), z.data()}, {20, 20}, row);
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
