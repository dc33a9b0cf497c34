#include "reports/class_style.h"

#include <array>
#include <cassert>

namespace zproof {

namespace {

constexpr std::array<ClassStyle, pixel_class_count> styles{{
    {{0x26, 0x2A, 0x31}, "·", "Both name the same triangle, and the depth lies within its bound."},
    {{0x56, 0xB4, 0xE9},
     "/",
     "Two triangles meet here, closer than the rounding of an edge. Either answer is admissible."},
    {{0x00, 0x72, 0xB2},
     "≈",
     "Two surfaces lie closer in depth than the precision can tell. Either answer is admissible."},
    {{0x00, 0x9E, 0x73},
     "┬",
     "A crack in the scene: surfaces touch here without sharing an edge. Admissible."},
    {{0x9A, 0xA0, 0xA8}, "|", "A surface crosses the near or far plane here. Either answer is admissible."},
    {{0xB4, 0xE6, 0xD2}, "R", "The reference gave an impossible answer, the candidate did not."},
    {{0xE6, 0x9F, 0x00}, "↕", "The right triangle, but its depth lies outside the bound."},
    {{0xD5, 0x5E, 0x00}, "○", "Background, where the scene covers the pixel for certain."},
    {{0xF0, 0xE4, 0x42}, "◇", "A triangle that does not reach this pixel."},
    {{0xCC, 0x79, 0xA7}, "▣", "A triangle that lies behind another for certain."},
    {{0xFF, 0xFF, 0xFF}, "×", "Not an answer at all: NaN, a negative depth, a triangle that does not exist."},
}};

}  // namespace

const ClassStyle& style_of(PixelClass c) {
    assert(std::size_t(c) < styles.size());
    return styles[std::size_t(c)];
}

}  // namespace zproof
