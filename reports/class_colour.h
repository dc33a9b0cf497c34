/// The colour of a pixel class as pictures hold it.
#pragma once

#include "compare/pixel_class.h"
#include "frame/picture.h"

namespace zproof {

constexpr Rgb8 colour_of(PixelClass c) {
    const std::uint32_t rgb = facts_of(c).colour;
    return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb)};
}

}  // namespace zproof
