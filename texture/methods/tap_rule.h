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
    return {.colour =
                [shared](const Footprint& footprint) {
                    glm::dvec4 sum{0};
                    (*shared)(footprint, [&](const Tap& tap) { sum += tap.weight * shared->value(tap); });
                    return sum;
                },
            .taps =
                [shared](const Footprint& footprint) {
                    std::vector<Tap> taps;
                    (*shared)(footprint, [&](const Tap& tap) { taps.push_back(tap); });
                    return taps;
                },
            .stored = std::move(stored)};
}

/// The texel of an image that holds a place, weighted.
template <class Read>
void read_nearest(const LinearImage& image, const Addressing& wrap, const glm::dvec2& place, Tap tap,
                  Read&& read) {
    tap.column = wrapped(wrap.u, std::int64_t(std::floor(place.x)), image.width);
    tap.row = wrapped(wrap.v, std::int64_t(std::floor(place.y)), image.height);
    read(tap);
}

/// The four texels whose centres surround a place of the image, weighted by product (OpenGL 4.6
/// core, 8.14.3).
template <class Read>
void read_bilinear(const LinearImage& image, const Addressing& wrap, const glm::dvec2& place, Tap tap,
                   Read&& read) {
    const glm::dvec2 low = glm::floor(place - 0.5), share = place - 0.5 - low;
    for (int down = 0; down < 2; ++down) {
        for (int right = 0; right < 2; ++right) {
            const double across = right == 1 ? share.x : 1 - share.x,
                         along = down == 1 ? share.y : 1 - share.y;
            read(Tap{tap.image, wrapped(wrap.u, std::int64_t(low.x) + right, image.width),
                     wrapped(wrap.v, std::int64_t(low.y) + down, image.height), tap.weight * across * along});
        }
    }
}

}  // namespace zproof::texture
