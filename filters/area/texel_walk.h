/// The texels that a convex piece of the image sees, each with the area of its part.
///
/// A line u = k of the texture is the straight line U - k W = 0 of the image, so texels are convex there too,
/// and cutting with straight lines loses nothing (docs/area-integral.md, "Texels").
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "filters/area/number.h"
#include "filters/area/polygon.h"
#include "math/affine.h"

namespace zproof::oracle::area {

/// A texel on the endless line of columns and rows, before any wrap.
struct Cell {
    std::int64_t column = 0, row = 0;
};

/// U - k W, >= 0 where u >= k; W > 0.
template <class Number>
Affine<Number> from_line(const Affine<Number>& u, std::int64_t k, const Affine<Number>& w) {
    return u - Number(double(k)) * w;
}

/// Places and areas of whole texels from the image's inverse: (x, y, 1) / W = M^-1 (u, v, 1), whose last
/// coordinate is Z = 1 / W. A triangle with homogeneous corners p_i has area |det(p0 p1 p2)| / (2 z0 z1 z2);
/// a texel is two of them, and z00 + z11 = z01 + z10.
template <class Number>
class TexelLattice {
  public:
    explicit TexelLattice(const Homography<Number>& map) {
        const auto& [u, v, w] = map;
        const Number minor_u = v.a * w.b - v.b * w.a, minor_v = u.b * w.a - u.a * w.b,
                     minor_1 = u.a * v.b - u.b * v.a;
        const Number det = minor_u * u.c + minor_v * v.c + minor_1 * w.c;
        if (det == 0) return;  // a texture seen edge-on has no whole texels
        x_ = {(v.b * w.c - v.c * w.b) / det, (w.b * u.c - w.c * u.b) / det, (u.b * v.c - u.c * v.b) / det};
        y_ = {(v.c * w.a - v.a * w.c) / det, (w.c * u.a - w.a * u.c) / det, (u.c * v.a - u.a * v.c) / det};
        z_ = {minor_u / det, minor_v / det, minor_1 / det};
        half_per_det_ = (det < 0 ? Number(-1) : Number(1)) / (Number(2) * det);
    }

    /// 1 / W as a functional of (u, v).
    const Affine<Number>& z() const { return z_; }
    /// |d(x, y) / d(u, v)| times Z^3.
    Number per_det() const { return Number(2) * half_per_det_; }
    Number z(std::int64_t u, std::int64_t v) const { return z_.at(Number(double(u)), Number(double(v))); }
    /// Where the image shows (u, v).
    Point<Number> place(const Number& u, const Number& v) const {
        const Number z = z_.at(u, v);
        return {x_.at(u, v) / z, y_.at(u, v) / z};
    }

    /// visit(cell, area) for the columns [first, last) of a row.
    template <class Visit>
    void visit_run(std::int64_t row, std::int64_t first, std::int64_t last, const Visit& visit) const {
        Number low = z(first, row), high = z(first, row + 1);
        for (std::int64_t k = first; k < last; ++k) {
            const Number next_low = z(k + 1, row), next_high = z(k + 1, row + 1);
            visit(Cell{k, row}, half_per_det_ * (high + next_low) / ((low * high) * (next_low * next_high)));
            low = next_low, high = next_high;
        }
    }

  private:
    Affine<Number> x_{}, y_{}, z_{};
    Number half_per_det_ = 0;
};

/// Visits cells through `visit.part(cell, polygon)`, for a part of a cell, and, where `visit.takes(lattice,
/// row, first, last)`, through `visit.whole` of the same, for the whole ones of columns [first, last).
template <class Number, class Visit>
class TexelWalk {
  public:
    TexelWalk(const Homography<Number>& map, Visit& visit) : map_(map), lattice_(map), visit_(visit) {}

    /// Rows from the least v to the greatest, split off one by one.
    void rows(Polygon<Number> rest) {
        if (rest.size() < 3) return;
        const auto [first, last] = range(rest, map_.v);
        Crossings<Number> below;
        for (std::int64_t row = first; row < last; ++row) {
            Halves<Number> halves = cut(rest, from_line(map_.v, row + 1, map_.w));
            columns(halves.outside, row, whole_columns(below, halves.crossings));
            rest = halves.inside;
            below = halves.crossings;
        }
        columns(rest, last, {0, 0});
    }

  private:
    using Run = std::pair<std::int64_t, std::int64_t>;

    std::int64_t place(const Affine<Number>& along, const Point<Number>& p) const {
        return floor_of(along.at(p.x, p.y) / map_.w.at(p.x, p.y));
    }

    /// Least and greatest texel of the corners.
    Run range(const Polygon<Number>& polygon, const Affine<Number>& along) const {
        Run run{place(along, polygon[0]), place(along, polygon[0])};
        for (const Point<Number>& p : polygon) {
            const std::int64_t at = place(along, p);
            run = {std::min(run.first, at), std::max(run.second, at)};
        }
        return run;
    }

    /// Lattice points within a chord of the piece: from the first to the last.
    Run lattice_points(const Crossings<Number>& chord) const {
        const Number a = map_.u.at(chord[0].x, chord[0].y) / map_.w.at(chord[0].x, chord[0].y);
        const Number b = map_.u.at(chord[1].x, chord[1].y) / map_.w.at(chord[1].x, chord[1].y);
        const Number low = a < b ? a : b, high = a < b ? b : a;
        return {-floor_of(-low), floor_of(high)};
    }

    /// A texel is whole where its four corners lie in the piece: columns [first, second).
    Run whole_columns(const Crossings<Number>& below, const Crossings<Number>& above) const {
        if (below.size() < 2 || above.size() < 2) return {0, 0};
        const Run low = lattice_points(below), high = lattice_points(above);
        return {std::max(low.first, high.first), std::min(low.second, high.second)};
    }

    void columns(const Polygon<Number>& strip, std::int64_t row, Run whole) {
        if (strip.size() < 3) return;
        constexpr std::int64_t worth_it = 2;
        if (whole.second - whole.first < worth_it || !visit_.takes(lattice_, row, whole.first, whole.second))
            return parts(strip, row);
        const Halves<Number> left = cut(strip, from_line(map_.u, whole.first, map_.w));
        const Halves<Number> right = cut(strip, from_line(map_.u, whole.second, map_.w));
        parts(left.outside, row);
        visit_.whole(lattice_, row, whole.first, whole.second);
        parts(right.inside, row);
    }

    void parts(Polygon<Number> rest, std::int64_t row) {
        if (rest.size() < 3) return;
        const auto [first, last] = range(rest, map_.u);
        for (std::int64_t column = first; column < last; ++column) {
            Halves<Number> halves = cut(rest, from_line(map_.u, column + 1, map_.w));
            if (halves.outside.size() > 2) visit_.part(Cell{column, row}, halves.outside);
            rest = halves.inside;
        }
        if (rest.size() > 2) visit_.part(Cell{last, row}, rest);
    }

    Homography<Number> map_;
    TexelLattice<Number> lattice_;
    Visit& visit_;
};

/// Texel coordinates counted from the texel that the piece's first corner sees, so that rounding is that of
/// the footprint's size, not of its distance from the texture's origin.
template <class Number>
struct Rebased {
    Homography<Number> map;
    Cell base;
};

template <class Number>
Rebased<Number> rebased(const Homography<Number>& map, const Point<Number>& at) {
    const auto [u, v] = map.at(at.x, at.y);
    const Cell base{floor_of(u), floor_of(v)};
    return {{from_line(map.u, base.column, map.w), from_line(map.v, base.row, map.w), map.w}, base};
}

}  // namespace zproof::oracle::area
