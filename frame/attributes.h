/// What a renderer interpolated over the triangle that each pixel shows.
#pragma once

#include <array>

#include "frame/plane.h"

namespace zproof {

/// Values at the pixels' centres; what stands at a pixel of background means nothing. A plane of size 0 x 0
/// is one that the renderer does not give.
struct Attributes {
    Plane<std::array<float, 2>> barycentric;     ///< weights of the triangle's second and third corner
    Plane<std::array<float, 2>> uv;              ///< of the first uv set
    Plane<std::array<float, 3>> position_world;  ///< scene units
};

}  // namespace zproof
