/// What a triangle's image keeps to, by its corners alone.
#pragma once

#include <array>
#include <cmath>

#include "compare/adjudicate/image_box.h"
#include "math/rounding.h"

namespace zproof {

/// The hull of the boxes that a triangle's corners lie in.
class CornerHull {
  public:
    explicit CornerHull(const std::array<Box, 3>& corners) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Box &from = corners[i], &to = corners[(i + 1) % 3];
            Side& side = sides_[i];  // any direction would do, so that its own rounding is harmless
            side.x = (from.top + from.bottom) - (to.top + to.bottom);
            side.y = (to.left + to.right) - (from.left + from.right);
            for (const Box& corner : corners) side.corners.add(across(side, corner));
        }
    }

    /// Does a line along one of the sides part the box from all three corners, certainly?
    bool is_beside(const Box& box) const {
        return std::ranges::any_of(sides_, [&](const Side& side) {
            const Range asked = across(side, box);
            return side.corners.least > asked.most || side.corners.most < asked.least;
        });
    }

  private:
    /// From the least to the greatest scalar product with a direction.
    struct Range {
        double least = HUGE_VAL, most = -HUGE_VAL;
        void add(const Range& o) { least = std::min(least, o.least), most = std::max(most, o.most); }
    };
    struct Side {
        double x = 0, y = 0;
        Range corners{};
    };
    /// Widened by what its 3 roundings may amount to.
    static Range across(const Side& side, const Box& box) {
        constexpr double rounding = gamma(4, unit_roundoff_float64);
        const double left = side.x * box.left, right = side.x * box.right, top = side.y * box.top,
                     bottom = side.y * box.bottom;
        const double unsure = rounding * (std::max(std::abs(left), std::abs(right)) +
                                          std::max(std::abs(top), std::abs(bottom)));
        return {std::min(left, right) + std::min(top, bottom) - unsure,
                std::max(left, right) + std::max(top, bottom) + unsure};
    }

    std::array<Side, 3> sides_;
};

}  // namespace zproof
