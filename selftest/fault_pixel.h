/// Pixels where a fault is certain to be one.
#pragma once

#include <compare>

#include "selftest/fault.h"

namespace zproof::selftest {

struct Pixel {
    int x = 0, y = 0;
    auto operator<=>(const Pixel&) const = default;
};

/// A pixel whose 7 x 7 neighbourhood is one triangle's, or all background, in both frames: no edge comes near
/// it. The first in raster order from the middle of the image on. Throws std::logic_error where there is
/// none.
Pixel amid_a_triangle(const Fixture& fixture);
Pixel amid_background(const Fixture& fixture);
/// A pixel as amid_a_triangle() gives it, amid another triangle than `first`.
Pixel amid_another_triangle(const Fixture& fixture, PrimitiveId first);

/// The admissible depths at a pixel of the good frame.
DepthBound admissible_depths(const Fixture& fixture, Pixel pixel);

/// The id that most pixels show, and the one that comes second.
struct CommonestIds {
    PrimitiveId first = PrimitiveId::none, second = PrimitiveId::none;
};
CommonestIds commonest_ids(const Frame& frame);

}  // namespace zproof::selftest
