/// Cosine and sine from + and * alone, so that no mathematics library can change a scene's bits.
#pragma once

#include <glm/glm.hpp>

namespace zproof::suite {

/// (cos, sin) of `turns` full turns, within 4 ulps of double; exact at multiples of a quarter turn.
glm::dvec2 unit_circle(double turns);

}  // namespace zproof::suite
