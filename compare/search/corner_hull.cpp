#include "compare/search/corner_hull.h"

#include "math/rounding.h"

namespace zproof {

/// Widened by what its 3 roundings may amount to.
[[gnu::always_inline]] inline auto CornerHull::across(const Box& box) const -> Range {
    constexpr double rounding = gamma(4, unit_roundoff_float64);
    const Four left = x_ * box.left, right = x_ * box.right, top = y_ * box.top, bottom = y_ * box.bottom;
    const Four unsure =
        rounding * (larger(absolute(left), absolute(right)) + larger(absolute(top), absolute(bottom)));
    return {smaller(left, right) + smaller(top, bottom) - unsure,
            larger(left, right) + larger(top, bottom) + unsure};
}

/// Any direction would do, so that its own rounding is harmless.
[[gnu::target_clones("default", "avx2")]] void CornerHull::draw(const CornerBoxes& corners) {
    const Four x = 0.5 * (corners.left + corners.right), y = 0.5 * (corners.top + corners.bottom);
    x_ = y - __builtin_shufflevector(y, y, 1, 2, 0, 0);
    y_ = __builtin_shufflevector(x, x, 1, 2, 0, 0) - x;
    const Range first = across(corners.of(0)), second = across(corners.of(1)), third = across(corners.of(2));
    corners_ = {smaller(smaller(first.least, second.least), third.least),
                larger(larger(first.most, second.most), third.most)};
}

[[gnu::target_clones("default", "avx2")]] bool CornerHull::is_beside(const Box& box) const {
    const Range asked = across(box);
    return holds_in_any((corners_.least > asked.most) | (corners_.most < asked.least));
}

}  // namespace zproof
