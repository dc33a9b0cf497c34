/// Where in a view's image something lies, for what POV-Ray need not be shown and for what it will cost.
#pragma once

#include <cstdint>
#include <span>

#include "scenes/view.h"

namespace zproof::oracle {

/// How many pixel centres lie in the rectangle around these points, which are given from the eye in the
/// world's axes, in any unit. The rectangle is widened by more than all rounding; so where the count is 0, no
/// ray meets what lies between the points. Points that may lie beside or behind a perspective eye span the
/// whole image.
std::uint64_t centres_around(std::span<const glm::dvec3> points_from_eye, const View& view, double unit);

}  // namespace zproof::oracle
