#include <array>
#include <string_view>

#include "scenes/filters/textures.h"

namespace zproof::filters {

namespace {

/// A letter of 5 x 7 fields, drawn for this: rows from the top, the leftmost field in bit 4.
struct Glyph {
    char name;
    std::array<std::uint8_t, 7> rows;
};

constexpr std::array glyphs{
    Glyph{'A', {0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001}},
    Glyph{'D', {0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110}},
    Glyph{'E', {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111}},
    Glyph{'F', {0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000}},
    Glyph{'G', {0b01111, 0b10000, 0b10000, 0b10011, 0b10001, 0b10001, 0b01111}},
    Glyph{'H', {0b10001, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001}},
    Glyph{'I', {0b01110, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    Glyph{'L', {0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b11111}},
    Glyph{'N', {0b10001, 0b11001, 0b10101, 0b10101, 0b10011, 0b10001, 0b10001}},
    Glyph{'O', {0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110}},
    Glyph{'P', {0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000, 0b10000}},
    Glyph{'R', {0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001}},
    Glyph{'T', {0b11111, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100}},
    Glyph{'X', {0b10001, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001, 0b10001}},
    Glyph{'Z', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b10000, 0b11111}},
};

constexpr std::string_view words = "FILTER THE TEXEL NOT THE PIXEL ZPROOF LEARN TO READ AT A GRAZING ANGLE ";

/// Whether a field of the letter is black; a column and a row between letters stay white.
bool is_ink(char name, int column, int row) {
    if (column >= 5 || row >= 7) return false;
    for (const Glyph& glyph : glyphs)
        if (glyph.name == name) return (glyph.rows[std::size_t(row)] >> (4 - column) & 1) != 0;
    return false;
}

/// A quarter of the texture's height for each size of stroke: 1, 2, 3 and 4 texels.
bool is_inked_texel(int column, int row) {
    const int stroke = 1 + row / 128, line = row % 128 / (9 * stroke), glyph = column / (6 * stroke);
    const auto place = (std::size_t(glyph) + std::size_t{11} * std::size_t(line)) % words.size();
    return is_ink(words[place], column / stroke % 6, row % 128 / stroke % 9);
}

}  // namespace

Image text() {
    return image_of("text", {},
                    [](int column, int row) { return glm::dvec3(is_inked_texel(column, row) ? 0 : 1); });
}

}  // namespace zproof::filters
