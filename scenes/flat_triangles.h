/// Triangles without area.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "scenes/scene.h"

namespace zproof {

/// How many of the triangles have area 0 as far as double can tell: every component of the cross product of
/// two edges is a difference of equal numbers.
std::uint64_t flat_among(std::span<const glm::uvec3> triangles, const Positions& positions);

}  // namespace zproof
