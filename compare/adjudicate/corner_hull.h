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
            SeparatingAxis& side = axes_[i];  // any direction would do, so that its own rounding is harmless
            side.x = (from.top + from.bottom) - (to.top + to.bottom);
            side.y = (to.left + to.right) - (from.left + from.right);
            for (const Box& corner : corners) side.corners.add(across(side, corner));
        }
    }

    /// Does a line along one of the sides part the box from all three corners, certainly?
    bool is_beside(const Box& box) const {
        return std::ranges::any_of(axes_, [&](const SeparatingAxis& side) {
            const AxisRange asked = across(side, box);
            return side.corners.least > asked.most || side.corners.most < asked.least;
        });
    }

  private:
    /// The range from the least to the greatest scalar product with a direction.
    struct AxisRange {
        double least = HUGE_VAL, most = -HUGE_VAL;
        void add(const AxisRange& o) { least = std::min(least, o.least), most = std::max(most, o.most); }
    };
    struct SeparatingAxis {
        double x = 0, y = 0;
        AxisRange corners{};
    };
    /// The range is widened by what its 3 roundings may amount to.
    static AxisRange across(const SeparatingAxis& side, const Box& box) {
        constexpr double rounding = gamma(4, unit_roundoff_float64);
        const double left = side.x * box.left, right = side.x * box.right, top = side.y * box.top,
                     bottom = side.y * box.bottom;
        const double unsure = rounding * (std::max(std::abs(left), std::abs(right)) +
                                          std::max(std::abs(top), std::abs(bottom)));
        return {std::min(left, right) + std::min(top, bottom) - unsure,
                std::max(left, right) + std::max(top, bottom) + unsure};
    }

    std::array<SeparatingAxis, 3> axes_;
};

}  // namespace zproof
