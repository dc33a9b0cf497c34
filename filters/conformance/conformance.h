/// Does a filtered picture keep to its definition? Each pixel is held against the colours that the filter
/// reference permits there (docs/filter-conformance.md).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "filters/conformance/filter_precision.h"
#include "filters/reference/permitted_colours.h"
#include "frame/picture.h"

namespace zproof {

/// The filter reference, asked about one pixel.
using PixelReference = std::function<PermittedColours(int x, int y, const FilterPrecision&)>;

struct FilterPixel {
    int x = 0, y = 0;
    auto operator<=>(const FilterPixel&) const = default;
};

/// The box of pixels that hold what is outside.
struct ExtentOutside {
    FilterPixel first, last;
};

struct Conformance {
    std::uint64_t judged = 0;    ///< all pixels
    std::uint64_t outside = 0;   ///< those that no range permits
    std::uint64_t anything = 0;  ///< those where the filter reference permits everything
    double worst_slack =
        0;                  ///< factor by which the widest-missing range would have to be widened; <= 1: none
    double mean_width = 0;  ///< of what is permitted, averaged over channels; how sharp the question was
    glm::dvec3 mean_width_of{0};  ///< the same by channel
    FilterPixel worst;
    std::optional<ExtentOutside> where;  ///< none where nothing is outside
    Plane<float> slack;                  ///< per pixel, for a picture
    Plane<glm::vec3> width{};            ///< of what is permitted, per pixel and channel
};

/// The permitted range that has to be widened least to hold the colour, the first of equals.
const ColourRange& nearest_range(const LinearRgb& colour, const PermittedColours& permitted);

/// The width of all ranges together, by channel, and averaged over the channels.
glm::dvec3 widths_of(const PermittedColours& permitted);
double width_of(const PermittedColours& permitted);

/// How far the nearest permitted range would have to be widened about its middle to hold the colour: |v -
/// middle| / half-width, the largest over the channels. Infinite where the colour is not finite.
double slack_of(const LinearRgb& colour, const PermittedColours& permitted);

/// As far from the middle of what is permitted, on the other side.
LinearRgb reflected(const LinearRgb& colour, const PermittedColours& permitted);

/// Some of the pixels with at least that slack, at most 400, taken evenly in raster order.
std::vector<FilterPixel> some_pixels(const Conformance& found, float least_slack);

/// Which of these pictures has a pixel outside? What is asked ends where all have. Runs on the threads of the
/// surrounding tbb::task_arena.
std::vector<bool> have_pixels_outside(std::span<const Picture> pictures, const PixelReference& reference,
                                      const FilterPrecision& precision);

/// Runs on the threads of the surrounding tbb::task_arena; all of them ask the filter reference.
Conformance conformance(const Picture& picture, const PixelReference& reference,
                        const FilterPrecision& precision);

}  // namespace zproof
