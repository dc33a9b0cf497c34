/// How far a picture lies from the truth, in linear light: one number per region of the image. Measures, not
/// verdicts. A new one is a file in metrics/ and a line in picture_metrics.cpp.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string_view>

#include "frame/plane.h"

namespace zproof {

/// Linear light in double: 0 black, 1 the brightest that an sRGB picture can show.
using LinearPicture = Plane<glm::dvec3>;

enum class Better { lower, higher };

/// A metric is a value per pixel, which may look at the pixel's surroundings in the whole image, and a way to
/// pool the values of a region. So a mask never changes what a pixel is worth.
struct PictureMetric {
    std::string_view name;        ///< as tables call it: lower case, unique
    std::string_view definition;  ///< one sentence
    std::string_view source;
    Better better = Better::lower;
    int decimals = 4;  ///< that a table shows
    /// The two planes have one size. What is not finite in the candidate gives +inf or NaN there, never 0.
    Plane<double> (*map)(const LinearPicture& candidate, const LinearPicture& truth);
    double (*pool)(std::span<double> values);  ///< of at least one; may reorder them
};

/// What of light a picture may show.
enum class LightRange {
    up_to_white,  ///< 0 to 1
    beyond_white  ///< as textures of floats have it
};

/// The metrics in the order of docs/filters.md: of light beyond white there are two more.
std::span<const PictureMetric> picture_metrics(LightRange range = LightRange::up_to_white);

/// Null where there is none of that name.
const PictureMetric* find_picture_metric(std::string_view name);

/// The metric over the pixels where the mask is not 0; NaN where there are none. Planes of one size
/// (std::invalid_argument otherwise).
double measured(const PictureMetric& metric, const Plane<double>& map, const Plane<std::uint8_t>& mask);

}  // namespace zproof
