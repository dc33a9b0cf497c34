#include "compare/strips/certain_depths.h"

#include <algorithm>
#include <cmath>

#include "compare/strips/masks.h"

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

/// Far from the corners.
class FarOff {
  public:
    FarOff(const DepthTolerance& t, const AtMost& at_most)
        : least_(t.least),
          most_(t.most),
          our_most_(std::min(t.candidate.lawful, at_most.candidate * t.candidate.room - t.unsure)),
          their_most_(std::min(t.reference.lawful, at_most.reference * t.reference.room - t.unsure)) {}

    bool holds_at(double w) const { return (w >= least_) & (w <= most_); }
    double our_most(double) const { return our_most_; }
    double their_most(double) const { return their_most_; }

  private:
    double least_, most_;
    double our_most_, their_most_;  ///< errors
};

/// And next to them.
class Anywhere {
  public:
    Anywhere(const DepthTolerance& t, const CornerTolerance& c, const AtMost& at_most)
        : unsure_(t.unsure), c_(c), at_most_(at_most) {}

    bool holds_at(double w) const { return (w >= c_.least) & (w <= c_.most); }
    double our_most(double w) const { return most_error(c_.candidate, w, at_most_.candidate); }
    double their_most(double w) const { return most_error(c_.reference, w, at_most_.reference); }

  private:
    double most_error(const CornerTolerance::Bound& bound, double w, double at_most) const {
        const double distance = std::min(w - c_.corner_least, c_.corner_most - w);
        const double room = bound.at_corners + bound.per_shift * std::min(bound.shift, distance);
        return std::min(std::min(room - bound.own, at_most * room) - unsure_, c_.largest);
    }

    double unsure_;
    CornerTolerance c_;
    AtMost at_most_;
};

template <class Projected, class Tolerated>
[[gnu::always_inline]] inline ColumnsOfBoth certain(const Row& row, const Tolerated& by,
                                                    const DepthsOfBoth& depths) {
    TileRowOf<std::uint32_t> ours, theirs;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const double w = row.w_at(i);
        const bool holds = by.holds_at(w);
        ours[i] = holds & (Projected::error(double(depths.candidate[i]), w) <= by.our_most(w));
        theirs[i] = holds & (Projected::error(double(depths.reference[i]), w) <= by.their_most(w));
    }
    return {where_equal(ours.data(), 1u), where_equal(theirs.data(), 1u)};
}

}  // namespace

// Compiled once per instruction set. No verdict depends on which runs: what is certain is so in any.
[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] ColumnsOfBoth certain_depths(
    const DepthTolerance& triangle, const CornerTolerance* next_to_corners, Projection projection,
    const DepthsOfBoth& depths, const AtMost& at_most) {
    const Row row(triangle, depths.place);
    const bool perspective = projection == Projection::perspective;
    if (!next_to_corners) {
        const FarOff by(triangle, at_most);
        return perspective ? certain<Perspective>(row, by, depths) : certain<Parallel>(row, by, depths);
    }
    const Anywhere by(triangle, *next_to_corners, at_most);
    return perspective ? certain<Perspective>(row, by, depths) : certain<Parallel>(row, by, depths);
}

}  // namespace zproof
