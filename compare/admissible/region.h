/// What is left of a convex region of the image plane when closed convex regions are taken away, exactly.
///
/// Every decision is the sign of a line's functional at a corner. Corners remember the lines they lie on, so
/// that a corner on the very line (a shared mesh edge, a shared mesh vertex) has sign 0 without arithmetic.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "math/affine.h"

namespace zproof {

/// The boundary of a half-plane `f >= 0`. Lines that are one and the same mesh edge have the same id (and
/// either sign); `ends` are the mesh corners that it joins, or -1. Mesh edges along one line of space have
/// the same `locus`, whatever their ends; -1 where that is not known.
template <class Number>
struct Line {
    Affine<Number> f;
    int id = -1;
    std::array<int, 2> ends{-1, -1};
    int locus = -1;
};

/// A closed convex polygon, possibly degenerate to a segment or a point, minus the closed half-planes whose
/// lines are `outside_of` (it lies where their functional is < 0). Lines must outlive it.
template <class Number>
class Region {
  public:
    /// The square |x|, |y| <= half_side; `sides` are its upper, right, lower and left line.
    static Region square(const std::array<const Line<Number>*, 4>& sides, const Number& half_side) {
        Region r;
        const Number &h = half_side, l = -half_side;
        r.corners_ = {{l, l, {sides[3], sides[0]}},
                      {h, l, {sides[0], sides[1]}},
                      {h, h, {sides[1], sides[2]}},
                      {l, h, {sides[2], sides[3]}}};
        return r;
    }

    /// The side of a line that each corner lies on.
    using Signs = std::vector<int>;
    Signs signs_at(const Line<Number>& line) const {
        Signs signs;
        signs.reserve(corners_.size());
        for (const Corner& c : corners_) signs.push_back(sign_at(c, line));
        return signs;
    }

    /// The part where f >= 0; nothing where it is empty. `signs` are what signs_at(line) says.
    std::optional<Region> inside(const Line<Number>& line, const Signs& signs) const {
        return clipped(line, +1, signs);
    }
    std::optional<Region> inside(const Line<Number>& line) const { return inside(line, signs_at(line)); }
    /// The part where f < 0, which the closed half-plane leaves.
    std::optional<Region> outside(const Line<Number>& line) const { return outside(line, signs_at(line)); }
    std::optional<Region> outside(const Line<Number>& line, const Signs& signs) const {
        std::optional<Region> r = clipped(line, -1, signs);
        if (!r) return r;
        r->outside_of_.push_back(&line);
        return r->reaches_outside_of(line) ? r : std::nullopt;
    }
    /// Is the region on the far side of the line, touching it at most?
    bool untouched_by(const Line<Number>& line) const {
        bool reaches = false;
        for (const Corner& c : corners_) {
            const int s = sign_at(c, line);
            if (s > 0) return false;
            reaches |= s < 0;
        }
        return reaches;
    }

    /// Does it reach the line?
    bool touches(const Line<Number>& line) const {
        return std::ranges::any_of(corners_, [&](const Corner& c) { return sign_at(c, line) == 0; });
    }

  private:
    struct Corner {
        Number x, y;
        std::array<const Line<Number>*, 2> on;
    };

    static int sign_at(const Corner& corner, const Line<Number>& line) {
        for (const Line<Number>* on : corner.on)
            if (on->id == line.id || (on->locus >= 0 && on->locus == line.locus)) return 0;
        for (const int end : corner.on[0]->ends)
            if (end >= 0 && std::ranges::count(corner.on[1]->ends, end) && std::ranges::count(line.ends, end))
                return 0;
        return sign(line.f.at(corner.x, corner.y));
    }

    /// Stands for a line that nobody remembers: it is no other one, and has no ends.
    static const Line<Number>* forgotten_line() {
        static const Line<Number> line{.f = {}, .id = std::numeric_limits<int>::min()};
        return &line;
    }

    /// The side that joins two neighbours. Where three lines or more meet, it may be one that the corner
    /// there does not remember: then arithmetic decides on which side of a line its crossings lie.
    static const Line<Number>* common_line(const Corner& a, const Corner& b) {
        for (const Line<Number>* on : a.on)
            if (on != forgotten_line() && (on->id == b.on[0]->id || on->id == b.on[1]->id)) return on;
        return forgotten_line();
    }

    static Corner crossing(const Corner& a, const Corner& b, const Line<Number>& line) {
        const Number fa = line.f.at(a.x, a.y), fb = line.f.at(b.x, b.y);
        const Number t = fa / (fa - fb);
        return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), {common_line(a, b), &line}};
    }

    /// The part where side * f >= 0.
    std::optional<Region> clipped(const Line<Number>& line, int side, const Signs& signs) const {
        const auto is_beyond = [&](int s) { return side * s < 0; };
        if (std::ranges::none_of(signs, is_beyond)) return *this;
        if (std::ranges::all_of(signs, is_beyond)) return std::nullopt;
        Region r;
        r.outside_of_ = outside_of_;
        r.corners_.reserve(corners_.size() + 1);
        for (size_t i = 0; i < corners_.size(); ++i) {
            const size_t j = (i + 1) % corners_.size();
            if (!is_beyond(signs[i])) r.corners_.push_back(corners_[i]);
            if (signs[i] * signs[j] < 0) r.corners_.push_back(crossing(corners_[i], corners_[j], line));
        }
        for (const Line<Number>* outer : r.outside_of_)
            if (!r.reaches_outside_of(*outer)) return std::nullopt;
        return r;
    }

    /// Does any point of the closed polygon have f < 0? An undecided corner only matters if no other decides.
    bool reaches_outside_of(const Line<Number>& line) const {
        return std::ranges::any_of(corners_, [&](const Corner& c) { return sign_at(c, line) < 0; });
    }

    std::vector<Corner> corners_;
    std::vector<const Line<Number>*> outside_of_;
};

/// A closed convex set that hides: the intersection of half-planes f >= 0. Their lines are owned elsewhere.
template <class Number>
using HalfPlanes = std::vector<const Line<Number>*>;

/// Takes a hiding set away from every region. What is left is empty iff the hiding sets cover everything.
template <class Number>
std::vector<Region<Number>> without(const std::vector<Region<Number>>& regions,
                                    const HalfPlanes<Number>& hiding) {
    std::vector<Region<Number>> left;
    for (const Region<Number>& region : regions) {
        const auto untouched = [&](const Line<Number>* line) { return region.untouched_by(*line); };
        if (std::ranges::any_of(hiding, untouched)) {
            left.push_back(region);
            continue;
        }
        std::optional<Region<Number>> rest = region;
        for (const Line<Number>* line : hiding) {
            const auto signs = rest->signs_at(*line);
            if (auto outside = rest->outside(*line, signs)) left.push_back(std::move(*outside));
            rest = rest->inside(*line, signs);
            if (!rest) break;
        }
    }
    return left;
}

}  // namespace zproof
