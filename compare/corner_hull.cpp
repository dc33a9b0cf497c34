#include "compare/corner_hull.h"

#include <algorithm>
#include <cmath>

#include "math/rounding.h"

namespace zproof {

/// Widened by what its 3 roundings may amount to.
auto CornerHull::Direction::of(const Box& box) const -> Range {
    static const double rounding = gamma(4, unit_roundoff_float64);
    const double left = x * box.left, right = x * box.right, top = y * box.top, bottom = y * box.bottom;
    const double unsure =
        rounding * (std::max(std::abs(left), std::abs(right)) + std::max(std::abs(top), std::abs(bottom)));
    return {std::min(left, right) + std::min(top, bottom) - unsure,
            std::max(left, right) + std::max(top, bottom) + unsure};
}

/// Any direction would do, so that its own rounding is harmless.
CornerHull::CornerHull(const std::array<Box, 3>& corners) {
    for (std::size_t i = 0; i < 3; ++i) {
        const Box &p = corners[i], &q = corners[(i + 1) % 3];
        const Direction across{p.middle_y() - q.middle_y(), q.middle_x() - p.middle_x()};
        Range all = across.of(p);
        for (const Box& corner : corners) {
            const Range one = across.of(corner);
            all = {std::min(all.least, one.least), std::max(all.most, one.most)};
        }
        sides_[i] = {across, all};
    }
}

bool CornerHull::is_beside(const Box& box) const {
    return std::ranges::any_of(sides_, [&](const Side& side) {
        const Range asked = side.across.of(box);
        return side.corners.least > asked.most || side.corners.most < asked.least;
    });
}

}  // namespace zproof
