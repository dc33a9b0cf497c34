/// The second pass: settles the pixels that the first left open, by the admissible set.
#pragma once

#include <span>

#include "compare/first_pass/pixel_look.h"
#include "compare/hearing/hearing.h"
#include "compare/pixel_place.h"

namespace zproof {

/// What the admissible set says of both answers at one pixel.
struct Ruling {
    Ruled candidate, reference;
};

/// Pixel by pixel, in the order asked for. What needs no ruling (both name the same triangle, or an answer is
/// none) has an empty one.
class Rulings {
  public:
    explicit Rulings(Bulk<Ruled> ruled) : ruled_(std::move(ruled)) {}

    Ruling operator[](std::size_t pixel) const { return {ruled_[2 * pixel], ruled_[2 * pixel + 1]}; }

  private:
    Bulk<Ruled> ruled_;  ///< candidate, reference, candidate ...
};

/// Rules on every open pixel, in order, on all threads.
Rulings rule_on(const Scene& scene, const View& view, const Witness& candidate, const Witness& reference,
                std::span<const PixelPlace> open, Asked asked = Asked::standing_and_displacement);

/// The word that an open pixel earns from its ruling.
PixelClass class_of(const OpenPixel& open, const Ruling& ruling);

}  // namespace zproof
