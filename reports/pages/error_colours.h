/// A map of errors as a picture.
#pragma once

#include "frame/picture.h"
#include "frame/plane.h"

namespace zproof {

/// What errors mean in colours: `low` and below is darkest, `high` and above lightest, equal ratios lie
/// equally far apart. NaN is grey.
struct ErrorScale {
    double low = 1e-9, high = 1;
};

Plane<Rgb8> error_colours(const Plane<float>& errors, const ErrorScale& scale);

}  // namespace zproof
