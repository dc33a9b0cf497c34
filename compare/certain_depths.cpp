#include "compare/certain_depths.h"

#include <algorithm>
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

}  // namespace

// Compiled once per instruction set. No verdict depends on which runs: what is certain is so in any.
[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] ColumnsOfBoth certain_depths(
    const DepthTolerance& triangle, Projection projection, const DepthsOfBoth& depths,
    const AtMost& at_most) {
    return projection == Projection::perspective ? certain<Perspective>(triangle, depths, at_most)
                                                 : certain<Parallel>(triangle, depths, at_most);
}

}  // namespace zproof
