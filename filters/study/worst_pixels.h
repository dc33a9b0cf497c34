/// Where pictures err most, region by region: the pixels that are worth an inspection.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/bounds/pixel_coord.h"
#include "filters/study/regions.h"
#include "frame/picture.h"

namespace zproof::study {

/// The greatest difference of a channel; +infinity where one is not finite.
double pixel_error(const LinearRgb& picture, const LinearRgb& truth);

/// By region: the pixel with the greatest error, the first in raster order of several; none where the region
/// is empty. Planes of one size.
std::vector<std::vector<PixelCoord>> worst_pixels(const Picture& picture, const Picture& truth,
                                                  std::span<const Region> regions);

/// The worst pixels of a method.
struct MethodPixels {
    std::string label;
    std::vector<std::vector<PixelCoord>> by_region;
};

/// At most so many pixels: of every method the worst of the first region, then of the second, and so on; each
/// pixel of a method once. Those of one method stand together, by rising row and column.
struct ChosenPixels {
    std::string label;
    std::vector<PixelCoord> pixels;
};
std::vector<ChosenPixels> chosen_pixels(std::span<const MethodPixels> methods, std::size_t most);

}  // namespace zproof::study
