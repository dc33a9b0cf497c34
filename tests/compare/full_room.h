/// What kernels rely on where they count on all of a tolerance's room.
#pragma once

#include <algorithm>
#include <cmath>

#include "compare/depth_tolerance.h"

namespace zproof {

/// Are all places that have the most room as far from the corners' as displacement goes, but for rounding?
inline bool has_full_room_inside_only(const DepthTolerance& t) {
    const double shift = std::max(t.candidate_there.shift, t.reference_there.shift) * (1 - 0x1p-40),
                 rounding = 0x1p-40 * (std::abs(t.corner_least) + std::abs(t.corner_most));
    return t.full_least >= std::max(t.least, t.corner_least + shift - rounding) &&
           t.full_most <= std::min(t.most, t.corner_most - shift + rounding);
}

}  // namespace zproof
