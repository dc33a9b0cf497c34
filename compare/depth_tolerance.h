/// How far a triangle's depths in a tile may be off and still be lawful for certain (docs/truth.md,
/// "Tolerances").
#pragma once

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
    /// One renderer's.
    struct Bound {
        Number room;    ///< error / bound is at most error / room
        Number lawful;  ///< and the depth lawful up to that ratio
    };

    Number w_per_x, w_per_y, w_offset;
    Number least, most;  ///< of w: between them it holds
    Number largest;      ///< no larger errors are told of
    Number unsure;       ///< what errors may be off by
    Bound candidate, reference;
};
using DepthTolerance = DepthToleranceOf<double>;

/// What of a triangle a tolerance is for. A displaced plane ends at the corners' depths, so that next to them
/// less of displacement counts.
enum class Reach {
    but_corners,  ///< all but what lies next to them
    all,
};

/// Where nothing is certain it holds nowhere: `least` is then larger than `most`.
DepthTolerance tolerance_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                            const PixelBox& part, Reach reach);

}  // namespace zproof
