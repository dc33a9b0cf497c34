/// Textures made in code, grey unless said otherwise, alpha 1. Values are linear light, encoded in sRGB and
/// rounded to 8 bits.
#pragma once

#include <functional>

#include "scenes/scene.h"

namespace zproof::filters {

struct TextureSize {
    int width = 512, height = 512;
};

/// Linear light in [0, 1] of the texel in a column and a row.
using Colour = std::function<glm::dvec3(int column, int row)>;
Image image_of(const std::string& name, TextureSize size, const Colour& colour);

/// The code / 255 nearest to a linear value, by the sRGB curve (IEC 61966-2-1).
std::uint8_t srgb_code(double linear);

/// Black and white checks of 32 texels, edges on the lattice.
Image lattice_checks();

/// Checks whose two extents are no whole number of texels and whose edges lie at irrational places; a texel
/// that an edge crosses has its mean. Whole periods fit the texture: 9 across, 7 down.
Image checks(TextureSize size);

/// Rings whose frequency grows with the radius, up to half a cycle per texel at the middle of each side.
Image zone_plate();

/// Independent texels, uniform in [0, 1): mt19937 with seed 1234, row by row.
Image white_noise();

/// Smooth noise in octaves, each half as fine and twice as strong as the next finer one, so that amplitude
/// falls as 1 / frequency. It repeats without a seam.
Image pink_noise(TextureSize size);

/// Black lines 2 texels wide in every 16th column and row, on white.
Image lines();

/// Lines of letters, 1 to 4 texels to a stroke, black on white.
Image text();

/// One white texel in 32 x 32, on black.
Image impulses();

/// Columns of 8 texels, dark and light by turns, with noise: mt19937 with seed 1234, row by row.
Image strips();

/// Checks of 1, 2, 4 ... 64 texels on top of each other, each size in a hue of its own, on grey: what a level
/// of a mip chain has averaged away loses its hue.
Image coloured_octaves();

}  // namespace zproof::filters
