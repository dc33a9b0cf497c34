/// Colours as words, for loops without branches: red in the lowest byte, then green, then blue.
#pragma once

#include <cassert>
#include <cstdint>
#include <cstring>
#include <span>

#include "frame/picture.h"

namespace zproof {

constexpr std::uint32_t word_of(Rgb8 colour) {
    return std::uint32_t{colour.r} | std::uint32_t{colour.g} << 8 | std::uint32_t{colour.b} << 16;
}

/// Stores as many pixels as words, at least one. Four bytes are stored at once where the next pixel will
/// overwrite the fourth.
inline void store(std::span<const std::uint32_t> words, std::span<Rgb8> pixels) {
    assert(words.size() == pixels.size() && !words.empty());
    const std::size_t last = pixels.size() - 1;
    for (std::size_t i = 0; i < last; ++i)
        std::memcpy(static_cast<void*>(&pixels[i]), &words[i], sizeof words[i]);
    std::memcpy(static_cast<void*>(&pixels[last]), &words[last], sizeof(Rgb8));
}

}  // namespace zproof
