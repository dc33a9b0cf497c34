/// How far two colour pictures of one view lie apart, in linear light, class by class: differences of shading
/// and texture are told apart from those of visibility. Measures, not verdicts.
#pragma once

#include <array>
#include <cstdint>

#include "compare/pixel_class.h"
#include "frame/picture.h"

namespace zproof {

/// The difference over the three channels of all pixels of a class.
struct PictureDifference {
    std::uint64_t pixels = 0;
    double rms = 0, mean = 0, largest = 0;  ///< mean and largest of absolute values; NaN counts as infinite
};

using PictureDifferences = std::array<PictureDifference, pixel_class_count>;

/// Three planes of one size (std::invalid_argument otherwise). Sums run in raster order: the same bits
/// always.
PictureDifferences differences(const Picture& a, const Picture& b, const Plane<PixelClass>& classes);

/// The severer class of each pixel.
Plane<PixelClass> severer(const Plane<PixelClass>& a, const Plane<PixelClass>& b);

}  // namespace zproof
