#include "compare/depth_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/estimate_row.h"
#include "compare/masks.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double u = unit_roundoff_float64, v = unit_roundoff_float32;

/// By what share places are let beyond their corners': 1 / (1 / depth) need not be depth, and nearness is
/// rounded.
constexpr double widening = 128 * u;

/// Bins are that many to a ratio of 1.
constexpr float bins = 20;

/// Numbers far from where single precision ends, so that no sum or product of a few of them leaves it.
constexpr double smallest = 0x1p-30, largest = 0x1p30;

/// Can a place be that near that no depth is left?
bool may_reach_zero(const DepthLaw& law, const DepthEstimate& plane, Projection projection) {
    const double per_depth =
        projection == Projection::perspective ? 2 * plane.most : 4 / plane.least;  // at the nearest place
    return !(law.absolute * per_depth < 0.5);
}

/// The folded law, and whether it is what the derivation in docs/truth.md asks for.
DepthEstimate::Bound bound_of(const DepthLaw& law, const DepthEstimate& plane, Projection projection) {
    const bool perspective = projection == Projection::perspective;
    const double reach = law.amplification * law.gradient;
    const double most_shift = law.most * law.gradient;
    // relative errors add up to factor + offset / w and are then compounded; how much that varies
    const double largest_sum = law.depth_factor + law.plane_offset / plane.least;
    const double variation = law.plane_offset / plane.least - law.plane_offset / plane.most;
    const double factor = perspective ? law.depth_factor / (1 - largest_sum) : law.relative;
    const double unsure = bins * (32 * v + 2 * variation) + 160 * widening / factor;
    const double own_error = (perspective ? 2 : 1) * law.own_error / plane.least;
    const double margin = 3 * (own_error + 10 * u) / factor;
    const bool is_common = perspective || (law.plane_offset == 0 && law.per == 0);
    const bool is_moderate = largest_sum < 0.5 && factor >= smallest && factor < 0.25 &&
                             law.per * reach < largest && law.base * reach < largest &&
                             most_shift + law.nearness_error <= plane.least / 2;
    const bool is_usable = is_common && is_moderate && unsure < 0.125 && margin < 0.25 &&
                           !may_reach_zero(law, plane, projection);
    return {.shift_base = float(law.base * reach),
            .most_shift = float(most_shift),
            .nearness_error = float(law.nearness_error),
            .beyond = std::isinf(law.farthest) ? float(largest) : 0.0f,
            .factor = float(factor),
            .absolute = float(law.absolute),
            .unsure = float(unsure),
            .top = is_usable ? float(bins * (1 - margin) - unsure) : -1.0f,
            .shift_per = float(law.per * reach),
            .plane_offset = float(law.plane_offset / (1 - largest_sum))};
}

/// The least that a place is displaced by, where nothing holds it back.
double least_shift(const DepthEstimate::Bound& bound, const DepthEstimate& plane) {
    if (bound.beyond == 0) return 0;
    const double varying = double{bound.shift_base} + double{bound.shift_per} * plane.least;
    return std::min(varying, double{bound.most_shift}) + double{bound.nearness_error};
}

/// See docs/truth.md.
DepthEstimate::Quiet quiet_of(const DepthEstimate::Bound& bound, const DepthEstimate& plane,
                              Projection projection, float known_largest) {
    const double ceiling = std::min({1.0f, bound.top, known_largest});
    const double share = (ceiling - double{bound.unsure}) / bins * (1 - 0x1p-16);
    if (!(share > 0)) return {};
    const double shift = least_shift(bound, plane), factor = bound.factor;
    const double room = projection == Projection::perspective ? shift + double{bound.plane_offset}
                                                              : shift * (1 - factor) + double{bound.absolute};
    return {.shift = float(shift), .slope = float(share * factor), .room = float(share * room)};
}

/// A triangle's plane.
struct Plane {
    double w_per_x, w_per_y, w_offset, least, most;
};

/// What one renderer's depths are held against: the same at every pixel, or to each its own.
struct OneTriangle {
    const DepthEstimate& t;
    const DepthEstimate::Bound bound;
    const DepthEstimate::Quiet quiet;

    void put_bounds(Projection) {}
    [[gnu::always_inline]] Plane plane_at(std::size_t) const {
        return {t.w_per_x, t.w_per_y, t.w_offset, t.least, t.most};
    }
    [[gnu::always_inline]] const DepthEstimate::Quiet& quiet_at(std::size_t) const { return quiet; }
    template <class Projected>
    [[gnu::always_inline]] DepthEstimate::Bound bound_at(std::size_t) const {
        return bound;
    }
};
/// One renderer's.
struct Whose {
    DepthEstimate::Bound DepthEstimate::*bound;
    DepthEstimate::Quiet DepthEstimate::*quiet;
};
constexpr Whose of_candidate{&DepthEstimate::candidate, &DepthEstimate::candidate_quiet},
    of_reference{&DepthEstimate::reference, &DepthEstimate::reference_quiet};

class OwnTriangles {
  public:
    struct Rows {
        EstimateRow::Quiet quiet;
        EstimateRow::Bound bound;
    };
    /// Into `rows`, which is only looked at.
    OwnTriangles(const Estimates& triangles, const Whose& whose, Rows& rows)
        : triangles_(triangles), whose_(whose), rows_(rows) {}

    void put_quiet() { put_side_by_side(triangles_, whose_.quiet, rows_.quiet); }
    void put_bounds(Projection projection) {
        put_side_by_side(triangles_, whose_.bound, projection, rows_.bound);
    }

    [[gnu::always_inline]] DepthEstimate::Quiet quiet_at(std::size_t i) const {
        return {rows_.quiet.shift[i], rows_.quiet.slope[i], rows_.quiet.room[i], 0};
    }
    template <class Projected>
    [[gnu::always_inline]] DepthEstimate::Bound bound_at(std::size_t i) const {
        const EstimateRow::Bound& b = rows_.bound;
        DepthEstimate::Bound bound{b.shift_base[i],
                                   b.most_shift[i],
                                   b.nearness_error[i],
                                   b.beyond[i],
                                   b.factor[i],
                                   b.absolute[i],
                                   b.unsure[i],
                                   b.top[i],
                                   0,
                                   0};
        if constexpr (Projected::is_perspective)
            bound.shift_per = b.shift_per[i], bound.plane_offset = b.plane_offset[i];
        return bound;
    }

  private:
    const Estimates& triangles_;
    const Whose& whose_;
    Rows& rows_;
};
struct OwnPlanes {
    EstimateRow::Plane row;

    explicit OwnPlanes(const Estimates& triangles) { put_side_by_side(triangles, row); }
    [[gnu::always_inline]] Plane plane_at(std::size_t i) const {
        return {row.w_per_x[i], row.w_per_y[i], row.w_offset[i], row.least[i], row.most[i]};
    }
};

/// Where pixels lie between their triangle's corners.
struct Spots {
    TileRow w;
    TileRowOf<float> w_float, to_least, to_most;
};

template <class Triangles>
[[gnu::always_inline]] inline void set_spots(const Triangles& triangles, const RowPlace& row, Spots& spots) {
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const Plane t = triangles.plane_at(i);
        const double w = t.w_per_x * double(row.left + int(i)) + t.w_per_y * row.y + t.w_offset;
        spots.w[i] = w;
        spots.w_float[i] = float(w);
        spots.to_least[i] = float(w - t.least);
        spots.to_most[i] = float(t.most - w);
    }
}

/// How far a depth is off, and by how much it may be, both over the same.
struct Perspective {
    static constexpr bool is_perspective = true;
    static constexpr Projection projection = Projection::perspective;
    static double error(double z, double nearness) { return z * nearness - 1; }
    static bool is_towards_most(float error) { return error < 0; }
    static float scaled(float error, float moved) { return error * moved; }
    static float shift(const DepthEstimate::Bound& b, float nearness) {
        return b.shift_base + b.shift_per * nearness;
    }
    static float room(const DepthEstimate::Bound& b, float nearness, float moved, float shift) {
        return shift + (b.factor * nearness + b.plane_offset) + b.absolute * nearness * moved;
    }
};
struct Parallel {
    static constexpr bool is_perspective = false;
    static constexpr Projection projection = Projection::parallel;
    static double error(double z, double depth) { return z - depth; }
    static bool is_towards_most(float error) { return error > 0; }
    static float scaled(float error, float) { return error; }
    static float shift(const DepthEstimate::Bound& b, float) { return b.shift_base; }
    static float room(const DepthEstimate::Bound& b, float, float moved, float shift) {
        return shift + b.factor * moved + b.absolute;
    }
};

/// One renderer's depths, and the largest ratio of them so far, as KnownLargest has it.
struct Seen {
    const float* depth;
    float known_largest;
    ColumnMask asked;
    bool may_be_quiet;
};

using Errors = TileRowOf<float>;

/// Where errors are that small, and places between the corners.
template <class Projected, class Triangles>
[[gnu::always_inline]] inline ColumnMask quiet_ones(const Triangles& triangles, const Spots& spots,
                                                    const Errors& errors) {
    TileRowOf<float> slack;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const DepthEstimate::Quiet quiet = triangles.quiet_at(i);
        const float w = spots.w_float[i];
        const float error = Projected::scaled(std::abs(errors[i]), w + quiet.shift);
        const float within = spots.to_least[i] < spots.to_most[i] ? spots.to_least[i] : spots.to_most[i];
        const float left = quiet.slope * w + quiet.room - error;
        slack[i] = within < left ? within : left;  // also where that is no number
    }
    return where_not_negative(slack.data());
}

/// The bins of one renderer's depths, and where they are certain.
template <class Projected, class Triangles>
[[gnu::always_inline]] inline void sort_loud(const Triangles& triangles, const Spots& spots,
                                             const Errors& errors, float known_largest,
                                             EstimatedRow::Side& side) {
    TileRowOf<float> slack, highs;
    for (std::size_t i = 0; i < tile_columns; ++i) {
        const DepthEstimate::Bound bound = triangles.template bound_at<Projected>(i);
        const float w = spots.w_float[i], error = errors[i];
        const float varying = Projected::shift(bound, w);
        const float shift = (varying < bound.most_shift ? varying : bound.most_shift) + bound.nearness_error;
        const float to_most = spots.to_most[i] + bound.beyond, to_least = spots.to_least[i] + bound.beyond;
        const float up = shift < to_most ? shift : to_most, down = -(shift < to_least ? shift : to_least);
        const float moves = Projected::is_towards_most(error) ? up : down;
        const float moved = w + moves;
        const float ratio = Projected::scaled(bins * std::abs(error), moved) /
                            Projected::room(bound, w, moved, std::abs(moves));
        const float low = ratio - bound.unsure, high = ratio + bound.unsure;
        const float at_most = high < bins ? high : bins;
        const auto whole = std::int32_t(at_most > 0 ? at_most : 0);
        side.bin[i] = whole;
        const float above = (low > 0 ? low : 0) - float(whole);
        const float within = spots.to_least[i] < spots.to_most[i] ? spots.to_least[i] : spots.to_most[i];
        const float here = high < bound.top ? above : -1;
        highs[i] = high;
        slack[i] = here < within ? here : within;
    }
    side.certain = where_not_negative(slack.data());
    side.may_exceed = all_columns & ~where_at_most(highs.data(), known_largest);
}

template <class Projected, class Triangles>
[[gnu::always_inline]] inline void sort_side(Triangles& triangles, const Spots& spots, const Seen& seen,
                                             EstimatedRow::Side& side) {
    Errors errors;
    for (std::size_t i = 0; i < tile_columns; ++i)
        errors[i] = float(Projected::error(double(seen.depth[i]), spots.w[i]));
    side.is_quiet = false;
    if (seen.may_be_quiet) {
        const ColumnMask quiet = quiet_ones<Projected>(triangles, spots, errors);
        side.is_quiet = (seen.asked & ~quiet) == 0;
        if (side.is_quiet) {
            side.bin.fill(0);
            side.certain = quiet;
            side.may_exceed = 0;
            return;
        }
        triangles.put_bounds(Projected::projection);
    }
    sort_loud<Projected>(triangles, spots, errors, seen.known_largest, side);
}

template <class Triangles>
[[gnu::always_inline]] inline void sort_side(Projection projection, Triangles triangles, const Spots& spots,
                                             const Seen& seen, EstimatedRow::Side& side) {
    if (projection == Projection::perspective)
        sort_side<Perspective>(triangles, spots, seen, side);
    else
        sort_side<Parallel>(triangles, spots, seen, side);
}

Seen seen_of_candidate(const Asked& asked, const DepthsOfBoth& depths) {
    return {depths.candidate, asked.known.candidate, asked.pixels, asked.may_be_quiet.candidate};
}
Seen seen_of_reference(const Asked& asked, const DepthsOfBoth& depths) {
    return {depths.reference, asked.known.reference, asked.pixels, asked.may_be_quiet.reference};
}

/// What will be asked for first.
void put_first(OwnTriangles& triangles, bool may_be_quiet, Projection projection) {
    if (may_be_quiet)
        triangles.put_quiet();
    else
        triangles.put_bounds(projection);
}

}  // namespace

DepthEstimate estimate_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                          const KnownLargest& known) {
    DepthEstimate t{};
    const bool perspective = projection == Projection::perspective;
    const double sign = perspective ? 1 : -1;
    t.w_per_x = sign * candidate.nearness_per_x;
    t.w_per_y = sign * candidate.nearness_per_y;
    t.w_offset = sign * candidate.nearness_offset;
    const double nearest = 1 / candidate.highest, farthest = 1 / candidate.least;
    t.least = perspective ? candidate.least : nearest;
    t.most = perspective ? candidate.highest : farthest;
    t.least *= 1 - widening, t.most *= 1 + widening;
    if (!(t.least >= smallest && t.most <= largest)) return t;
    t.candidate = bound_of(candidate, t, projection);
    t.reference = bound_of(reference, t, projection);
    t.is_usable = t.candidate.top > 0 && t.reference.top > 0;
    if (!t.is_usable) t.candidate.top = t.reference.top = -1;
    t.candidate_quiet = quiet_of(t.candidate, t, projection, known.candidate);
    t.reference_quiet = quiet_of(t.reference, t, projection, known.reference);
    return t;
}

// Compiled once per instruction set. No verdict depends on which runs: what is certain is so in any.

[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] void estimate(
    const DepthEstimate& triangle, const Asked& asked, const DepthsOfBoth& depths, EstimatedRow& estimated) {
    const OneTriangle ours{triangle, triangle.candidate, triangle.candidate_quiet},
        theirs{triangle, triangle.reference, triangle.reference_quiet};
    Spots spots;
    set_spots(ours, depths.place, spots);
    sort_side(asked.projection, ours, spots, seen_of_candidate(asked, depths), estimated.candidate);
    sort_side(asked.projection, theirs, spots, seen_of_reference(asked, depths), estimated.reference);
}

[[gnu::flatten, gnu::target_clones("default", "avx2", "arch=x86-64-v4")]] void estimate(
    const EstimatesOfBoth& triangles, const Asked& asked, const DepthsOfBoth& depths,
    EstimatedRow& estimated) {
    OwnTriangles::Rows of_ours, of_theirs;
    OwnTriangles ours(triangles.ours, of_candidate, of_ours),
        theirs(triangles.theirs, of_reference, of_theirs);
    // Long before they are read, and in wider vectors.
    put_first(ours, asked.may_be_quiet.candidate, asked.projection);
    put_first(theirs, asked.may_be_quiet.reference, asked.projection);
    Spots spots;
    set_spots(OwnPlanes(triangles.ours), depths.place, spots);
    sort_side(asked.projection, ours, spots, seen_of_candidate(asked, depths), estimated.candidate);
    if (&triangles.ours != &triangles.theirs) set_spots(OwnPlanes(triangles.theirs), depths.place, spots);
    sort_side(asked.projection, theirs, spots, seen_of_reference(asked, depths), estimated.reference);
}

}  // namespace zproof
