/// The texture that filters read: linear light, float32, taken as exact numbers.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "texture/texels.h"

namespace zproof::texture {

/// Row 0 first, which is v = 0; texel (i, j) covers [i, i + 1) x [j, j + 1) in texel coordinates. RGBA, alpha
/// not premultiplied.
struct LinearImage {
    int width = 0, height = 0;      ///< at least 1
    std::vector<glm::vec4> texels;  ///< width * height

    const glm::vec4& at(int column, int row) const {
        return texels[std::size_t(row) * std::size_t(width) + std::size_t(column)];
    }
    glm::vec4& at(int column, int row) {
        return texels[std::size_t(row) * std::size_t(width) + std::size_t(column)];
    }
};

/// The image decoded from sRGB in double, rounded once.
LinearImage linear_image(const Texels& stored);

/// The codes of its colours, 0 to 1, as if they were linear light: each rounded once.
LinearImage image_of_codes(const Texels& stored);

}  // namespace zproof::texture
