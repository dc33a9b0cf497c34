/// From figures to a promise, and the judge's word on it.
#pragma once

#include <vector>

#include "compare/bounds/pixel_coord.h"
#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::measure {

/// The least decimal of three significant digits that is not below a positive number.
double rounded_up(double value);

/// The depth_relative that a promise must name for depths that err by this share: at least 2^least_octave,
/// rounded up.
double promised_relative(double error);

/// The pixels that the judge calls defects under the promise. It is asked about every pixel, against a
/// reference that answers nothing: so no answer is taken for right because somebody else gives it, too.
std::vector<PixelCoord> defects_under(const BoundedPrecision& promise, const Scene& scene, const View& view,
                                      const Frame& frame);

}  // namespace zproof::measure
