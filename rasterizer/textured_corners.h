/// The corners of a triangle in the world and on its base-colour texture.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// A corner with the eye as the origin, world axes, and its place on the texture.
struct TexturedCorner {
    glm::dvec3 from_eye{0};
    glm::dvec2 texel{0};  ///< texels of level 0
};

/// The corners' places on the texture, texels of level 0; none where the vertices have no such uv set.
std::optional<std::array<glm::dvec2, 3>> texels_of(const Scene& scene, const Texture& texture,
                                                   std::uint32_t triangle);

/// None where the material has no texture or the vertices have no such uv set.
std::optional<std::array<TexturedCorner, 3>> textured_corners(const Scene& scene, const View& view,
                                                              std::uint32_t triangle);

}  // namespace zproof::rasterizer
