/// How far a triangle's depths in a tile may be off and still be lawful for certain (docs/truth.md,
/// "Tolerances").
#pragma once

#include <limits>

#include "compare/depth_law.h"

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
    /// Where the renderer keeps to the corners' depths a displaced plane ends at them, so that less of
    /// displacement counts next to them: the room is
    /// at_corners + per_shift * min(shift, distance of w from theirs), and the depth lawful up to that - own.
    struct NextToCorners {
        Number at_corners, per_shift, shift, own;
    };

    Number w_per_x, w_per_y, w_offset;
    Number full_least, full_most;  ///< of w: between them with the most room
    Number unsure;                 ///< what errors may be off by; `lawful` is less by that
    Bound candidate, reference;

    Number least, most;                ///< of w: between them with less, next to corners
    Number corner_least, corner_most;  ///< of w, at the corners
    Number largest;                    ///< no larger errors are told of
    NextToCorners candidate_there, reference_there;
};
using DepthTolerance = DepthToleranceOf<double>;

/// It holds nowhere, and nothing is said of the triangle.
inline constexpr DepthTolerance tolerance_of_nothing = [] {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    DepthTolerance t{};
    t.w_per_x = t.w_per_y = std::numeric_limits<double>::quiet_NaN();
    t.least = t.full_least = infinite, t.most = t.full_most = -infinite;
    return t;
}();

/// Where nothing is certain it holds nowhere: `least` is then larger than `most`.
DepthTolerance tolerance_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                            const PixelBox& part);

}  // namespace zproof
