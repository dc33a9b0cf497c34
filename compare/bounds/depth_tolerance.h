/// How far a triangle's depths in a tile may be off and still be lawful for certain (docs/truth.md,
/// "Tolerances").
#pragma once

#include <limits>

#include "compare/bounds/depth_law.h"
#include "scenes/view.h"

namespace zproof {

/// Pixels [left, right) x [top, bottom).
struct PixelBox {
    int left, top, right, bottom;
};

/// One triangle in a part of the image, as both renderers have it. A place along the depth axis, `w`, is
/// nearness for perspectives and depth for parallel projections; it is affine in the image. An error is
/// |z w - 1| for perspectives, |z - w| for parallel projections.
template <class Number>
struct DepthToleranceOf {
    /// One renderer's: error / bound is at most error / room, and the depth lawful up to an error of
    /// `lawful`.
    struct Bound {
        Number room, lawful;
    };

    Number w_per_x, w_per_y, w_offset;
    Number least, most;  ///< of w: between them it holds
    Number unsure;       ///< what errors may be off by; `lawful` is less by that
    Bound candidate, reference;
};
using DepthTolerance = DepthToleranceOf<double>;

/// What holds next to its corners, too. Where a renderer keeps to the corners' depths a displaced plane ends
/// at them, so that there less of displacement counts.
template <class Number>
struct CornerToleranceOf {
    /// One renderer's: the room is at_corners + per_shift * min(shift, distance of w from the corners'), and
    /// the depth lawful up to an error of that - own.
    struct Bound {
        Number at_corners, per_shift, shift, own;
    };

    Number least, most;                ///< of w: between them it holds
    Number corner_least, corner_most;  ///< of w, at the corners
    Number largest;                    ///< no larger errors are told of
    Bound candidate, reference;
};
using CornerTolerance = CornerToleranceOf<double>;

/// It holds nowhere, and nothing is said of the triangle.
inline constexpr DepthTolerance tolerance_of_nothing = [] {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    DepthTolerance t{};
    t.w_per_x = t.w_per_y = std::numeric_limits<double>::quiet_NaN();
    t.least = infinite, t.most = -infinite;
    return t;
}();
inline constexpr CornerTolerance corner_tolerance_of_nothing = [] {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    CornerTolerance t{};
    t.least = infinite, t.most = -infinite;
    return t;
}();

template <class Number>
struct TolerancesOf {
    DepthToleranceOf<Number> far_off;  ///< from the corners
    CornerToleranceOf<Number> next_to_corners;
};
using Tolerances = TolerancesOf<double>;

/// Where nothing is certain both hold nowhere: `least` is then larger than `most`.
Tolerances tolerances_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                         const PixelBox& part);

}  // namespace zproof
