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

/// A triangle along a row.
struct Row {
    double w_per_x, w_of_row, w_offset;
    int left;

    Row(const DepthTolerance& t, const RowPlace& place)
        : w_per_x(t.w_per_x), w_of_row(t.w_per_y * place.y), w_offset(t.w_offset), left(place.left) {}

    double w_at(std::size_t i) const { return w_per_x * double(left + int(i)) + w_of_row + w_offset; }
};

/// Up to that an error is, so far from the corners.
[[gnu::always_inline]] inline double most_error(const DepthTolerance& t,
                                                const DepthTolerance::NextToCorners& there, double distance,
                                                double at_most) {
    const double room = there.at_corners + there.per_shift * std::min(there.shift, distance);
    return std::min(std::min(room - there.own, at_most * room) - t.unsure, t.largest);
}

template <class Projected>
[[gnu::always_inline]] inline ColumnsOfBoth certain(const DepthTolerance& t, const DepthsOfBoth& depths,
                                                    const AtMost& at_most) {
    const Row row(t, depths.place);
    TileRowOf<std::uint32_t> ours, theirs;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const double w = row.w_at(i);
        const double distance = std::min(w - t.corner_least, t.corner_most - w);
        const bool holds = (w >= t.least) & (w <= t.most);
        ours[i] = holds & (Projected::error(double(depths.candidate[i]), w) <=
                           most_error(t, t.candidate_there, distance, at_most.candidate));
        theirs[i] = holds & (Projected::error(double(depths.reference[i]), w) <=
                             most_error(t, t.reference_there, distance, at_most.reference));
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
