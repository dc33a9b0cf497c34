/// How much of the surfaces that show a texture each of its texels covers.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "texture/texels.h"

namespace zproof::texture {

/// A triangle that shows a texture.
struct SurfaceTriangle {
    std::array<glm::dvec2, 3> corners{};  ///< on the texture, texels of level 0
    double area_world = 0;
    Addressing addressing{};
};

/// Every triangle that shows a texture, found when asked for.
using Surface = std::function<std::vector<SurfaceTriangle>()>;

/// Each texel's area in the world, row by row, as a share of the largest, rounded to multiples of 2^-24. A
/// triangle that is more than 2^20 texels wide or high, or reaches beyond 2^40, covers all texels alike.
/// Empty where no triangle covers anything.
std::vector<double> texel_weights(const std::vector<SurfaceTriangle>& surface, int width, int height);

}  // namespace zproof::texture
