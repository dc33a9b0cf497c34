#include "filters/conformance/picture_format.h"

#include <cmath>

#include "math/srgb.h"

namespace zproof {

namespace {

float as_code(float light) {
    return float(decoded_srgb(std::floor(255 * encoded_srgb(double{light}) + 0.5) / 255));
}

}  // namespace

Picture as_stored(Picture picture, const FilterPrecision& promise) {
    if (promise.code_error > 0)
        for (LinearRgb& pixel : picture.pixels())
            pixel = {as_code(pixel.r), as_code(pixel.g), as_code(pixel.b)};
    return picture;
}

}  // namespace zproof
