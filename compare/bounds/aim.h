/// How far a rounded view ray passes beside the pixel's centre (docs/bounds.md, "A ray caster").
#pragma once

#include "compare/bounds/view_facts.h"

namespace zproof {

struct Aim {
    /// Relative errors of each coordinate of directions and origins, and what is aimed beside on purpose.
    Aim(const ViewFacts& facts, double direction_error, double origin_error, double offset_px);

    double at_depth_px(double depth) const { return px + px_per_depth * (depth + start); }

    double px, px_per_depth;                ///< sideways; per unit along the ray in parallel projections
    double start;                           ///< how far behind the eye rays start
    double depth_relative, depth_absolute;  ///< along the view axis
};

}  // namespace zproof
