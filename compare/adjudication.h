/// The second pass: settles the pixels that the first left open, by the admissible set.
#pragma once

#include <span>

#include "compare/agreement.h"
#include "compare/hearing.h"

namespace zproof {

/// What the admissible set says of both answers at one pixel.
struct Ruling {
    Ruled candidate, reference;
};

/// Rules on every open pixel, in order, on all threads.
std::vector<Ruling> rule_on(const Scene& scene, const View& view, const Witness& candidate,
                            const Witness& reference, std::span<const OpenPixel> open);

/// The word that an open pixel earns from its ruling.
PixelClass class_of(const OpenPixel& open, const Ruling& ruling);

}  // namespace zproof
