#include "compare/certain_depths.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "compare/masks.h"

namespace zproof {

namespace {

struct Perspective {
    static double error(double z, double nearness) { return std::abs(z * nearness - 1); }
};
struct Parallel {
    static double error(double z, double depth) { return std::abs(z - depth); }
};

/// Up to that an error is.
double most_error(const DepthTolerance& t, const DepthTolerance::Bound& bound, double at_most) {
    return std::min(std::min(bound.lawful, at_most) * bound.room - t.unsure, t.largest);
}

/// A triangle along a row.
struct Row {
    double w_per_x, w_of_row, w_offset, least, most;
    double our_most, their_most;  ///< errors
    int left;

    Row(const DepthTolerance& t, const RowPlace& place, const AtMost& at_most)
        : w_per_x(t.w_per_x),
          w_of_row(t.w_per_y * place.y),
          w_offset(t.w_offset),
          least(t.least),
          most(t.most),
          our_most(most_error(t, t.candidate, at_most.candidate)),
          their_most(most_error(t, t.reference, at_most.reference)),
          left(place.left) {}

    double w_at(std::size_t i) const { return w_per_x * double(left + int(i)) + w_of_row + w_offset; }
    bool holds_at(double w) const { return (w >= least) & (w <= most); }
};

template <class Projected>
[[gnu::always_inline]] inline ColumnsOfBoth certain(const DepthTolerance& t, const DepthsOfBoth& depths,
                                                    const AtMost& at_most) {
    const Row row(t, depths.place, at_most);
    TileRowOf<std::uint32_t> ours, theirs;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const double w = row.w_at(i);
        const bool holds = row.holds_at(w);
        ours[i] = holds & (Projected::error(double(depths.candidate[i]), w) <= row.our_most);
        theirs[i] = holds & (Projected::error(double(depths.reference[i]), w) <= row.their_most);
    }
    return {where_equal(ours.data(), 1u), where_equal(theirs.data(), 1u)};
}

/// Both depths, where that is asked.
template <class Projected>
[[gnu::always_inline]] inline ColumnMask both_certain(const Row& row, const DepthsOfBoth& depths) {
    ColumnMask both = 0;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const double w = row.w_at(i);
        const bool is_certain = row.holds_at(w) &
                                (Projected::error(double(depths.candidate[i]), w) <= row.our_most) &
                                (Projected::error(double(depths.reference[i]), w) <= row.their_most);
        both |= is_certain ? ColumnMask{1} << i : 0;
    }
    return both;
}

/// A strip's, all of which shows one triangle.
template <class Projected>
[[gnu::always_inline]] inline bool are_all_certain(const Strip& strip, const Row& row) {
    TileRowOf<std::uint32_t> all;
    all.fill(1);
    for (std::size_t first = 0; first < Strip::width; first += tile_columns)
        for (std::size_t lane = 0; lane < tile_columns; ++lane) {
            const std::size_t i = first + lane;
            const double w = row.w_at(i), ours = double(strip.candidate.camera_depth[i]),
                         theirs = double(strip.reference.camera_depth[i]);
            all[lane] &= row.holds_at(w) & (Projected::error(ours, w) <= row.our_most) &
                         (Projected::error(theirs, w) <= row.their_most);
        }
    return where_equal(all.data(), 1u) == all_columns;
}

/// Triangle by triangle.
template <class Projected>
[[gnu::always_inline]] inline Strip::Pixels certain(const Strip& strip, const Tolerances& tolerances,
                                                    const AtMost& at_most) {
    const DepthTolerance& first_shown = tolerances[strip.candidate.law[0]];
    if (strip.is_of_one_id() && are_all_certain<Projected>(strip, {first_shown, {strip.x, strip.y}, at_most}))
        return ~Strip::Pixels{0};
    Strip::Pixels all = 0;
    for (std::size_t first = 0; first < Strip::width; first += Strip::chunk) {
        const std::uint32_t* const laws = &strip.candidate.law[first];
        const DepthsOfBoth depths{{strip.x + int(first), strip.y},
                                  &strip.candidate.camera_depth[first],
                                  &strip.reference.camera_depth[first]};
        ColumnMask left = Strip::in_chunk(~strip.differ, first), certain = 0;
        while (left != 0) {
            const std::uint32_t law = laws[std::countr_zero(left)];
            const ColumnMask here = left & where_equal(laws, law);
            left &= ~here;
            certain |= here & both_certain<Projected>({tolerances[law], depths.place, at_most}, depths);
        }
        all |= Strip::Pixels{certain} << first;
    }
    return all;
}

}  // namespace

// Compiled once per instruction set. No verdict depends on which runs: what is certain is so in any.
[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] ColumnsOfBoth certain_depths(
    const DepthTolerance& triangle, Projection projection, const DepthsOfBoth& depths,
    const AtMost& at_most) {
    return projection == Projection::perspective ? certain<Perspective>(triangle, depths, at_most)
                                                 : certain<Parallel>(triangle, depths, at_most);
}

[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] Strip::Pixels certain_pixels(
    const Strip& strip, const Tolerances& tolerances, Projection projection, const AtMost& at_most) {
    return projection == Projection::perspective ? certain<Perspective>(strip, tolerances, at_most)
                                                 : certain<Parallel>(strip, tolerances, at_most);
}

}  // namespace zproof
