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
struct DepthTolerance {
    /// One renderer's.
    struct Bound {
        double room;    ///< error / bound is at most error / room
        double lawful;  ///< and the depth lawful up to that ratio
    };

    double w_per_x = 0, w_per_y = 0, w_offset = 0;
    double least = std::numeric_limits<double>::infinity(), most = -least;  ///< of w: between them it holds
    double largest = 0;                                                     ///< no larger errors are told of
    double unsure = 0;                                                      ///< what errors may be off by
    Bound candidate{}, reference{};
};

/// What of a triangle a tolerance is for. A displaced plane ends at the corners' depths, so that next to them
/// less of displacement counts.
enum class Reach {
    but_corners,  ///< all but what lies next to them
    all,
};

/// It holds nowhere where nothing is certain.
DepthTolerance tolerance_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                            const PixelBox& part, Reach reach);

}  // namespace zproof
