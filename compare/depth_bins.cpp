#include "compare/depth_bins.h"

#include <cmath>

#include "compare/masks.h"

namespace zproof {

namespace {

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
    /// Writes into `rows` what is put, no sooner.
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

    float within(std::size_t i) const { return to_least[i] < to_most[i] ? to_least[i] : to_most[i]; }
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
        const float within = spots.within(i);
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
        const float ratio = Projected::scaled(bins_per_ratio * std::abs(error), moved) /
                            Projected::room(bound, w, moved, std::abs(moves));
        const float low = ratio - bound.unsure, high = ratio + bound.unsure;
        const float at_most = high < bins_per_ratio ? high : bins_per_ratio;
        const auto whole = std::int32_t(at_most > 0 ? at_most : 0);
        side.bin[i] = whole;
        const float above = (low > 0 ? low : 0) - float(whole);
        const float within = spots.within(i);
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
