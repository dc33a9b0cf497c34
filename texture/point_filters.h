/// Filters that look at the place alone, not at the pixel's footprint: nearest and bilinear, in linear light.
/// Coordinates are those of glTF and OpenGL: texel (i, j) covers [i, i + 1] / width, its centre at i + 1/2
/// (OpenGL 4.6 core, 8.14.3). What is not finite reads as coordinate 0.
#pragma once

#include "texture/texels.h"

namespace zproof::texture {

/// The texel that holds the place.
glm::dvec4 nearest(const Texels& texels, const Addressing& addressing, const glm::dvec2& uv);

/// The four texels whose centres surround it, weighted by product.
glm::dvec4 bilinear(const Texels& texels, const Addressing& addressing, const glm::dvec2& uv);

}  // namespace zproof::texture
