/// A tap rule is written once, as a template that hands its reads to a reader, and gives both the colour and
/// the list of taps.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "texture/method.h"

namespace zproof::texture {

/// Rule: `void operator()(const Footprint&, auto&& read) const`, calling `read(Tap)`, and
/// `glm::dvec4 value(const Tap&) const`, the stored value. `stored` describes what it keeps.
template <class Rule>
Sampler sampler(Rule rule, std::vector<StoredImage> stored) {
    const auto shared = std::make_shared<const Rule>(std::move(rule));
    Sampler made;
    made.colour = [shared](const Footprint& footprint) {
        glm::dvec4 sum{0};
        (*shared)(footprint, [&](const Tap& tap) { sum += tap.weight * shared->value(tap); });
        return sum;
    };
    made.taps = [shared](const Footprint& footprint) {
        std::vector<Tap> taps;
        (*shared)(footprint, [&](const Tap& tap) { taps.push_back(tap); });
        return taps;
    };
    made.stored = std::move(stored);
    return made;
}

/// The image itself as a stored image.
inline StoredImage level_zero(const LinearImage& image) {
    return {image.width, image.height, sizeof(glm::vec4), [](int column, int row) {
                return std::vector<Share>{{column, row, 1}};
            }};
}

/// Texel coordinates for which a 64-bit index exists: what is not finite or beyond 2^52 reads as 0.
inline double place_on_line(double place) { return std::abs(place) < 0x1p52 ? place : 0; }

/// The index of the texel that holds a place on the line, before wrapping.
inline std::int64_t texel_holding(double place) { return std::int64_t(std::floor(place_on_line(place))); }

/// The texel of an image that holds a place, weighted.
template <class Read>
void read_nearest(const LinearImage& image, const Addressing& wrap, const glm::dvec2& place, Tap tap,
                  Read&& read) {
    tap.column = wrapped(wrap.u, texel_holding(place.x), image.width);
    tap.row = wrapped(wrap.v, texel_holding(place.y), image.height);
    read(tap);
}

/// The four texels whose centres surround a place of the image, weighted by product (OpenGL 4.6
/// core, 8.14.3).
template <class Read>
void read_bilinear(const LinearImage& image, const Addressing& wrap, const glm::dvec2& place, Tap tap,
                   Read&& read) {
    const glm::dvec2 between{place_on_line(place.x) - 0.5, place_on_line(place.y) - 0.5},
        low = glm::floor(between), share = between - low;
    const auto left = std::int64_t(low.x), upper = std::int64_t(low.y);
    const int columns[2] = {wrapped(wrap.u, left, image.width), wrapped(wrap.u, left + 1, image.width)},
              rows[2] = {wrapped(wrap.v, upper, image.height), wrapped(wrap.v, upper + 1, image.height)};
    for (std::size_t down = 0; down < 2; ++down) {
        for (std::size_t right = 0; right < 2; ++right) {
            const double across = right == 1 ? share.x : 1 - share.x,
                         along = down == 1 ? share.y : 1 - share.y;
            read(Tap{tap.image, columns[right], rows[down], tap.weight * across * along});
        }
    }
}

}  // namespace zproof::texture
