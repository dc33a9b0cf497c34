/// What a picture keeps of its colours.
#pragma once

#include "filters/conformance/filter_precision.h"
#include "frame/picture.h"

namespace zproof {

/// The picture as the promise stores it: as it is, or each channel as the nearest 8-bit sRGB code.
Picture as_stored(Picture picture, const FilterPrecision& promise);

}  // namespace zproof
