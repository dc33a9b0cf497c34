/// Maps the image to a triangle's base-colour texture.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "math/affine.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// How texture coordinates run across a triangle.
enum class UvInterpolation {
    perspective,  ///< u / depth, v / depth and 1 / depth are affine in the image (Heckbert and Moreton 1991)
    affine,  ///< u and v are affine in the image between the projected corners: wrong wherever depths differ
};

/// Texel coordinates of level 0 as functions of the raster position, by perspective; w is 1 / depth (parallel
/// projections: 1). None where the material has no texture, the vertices have no such uv set, or the plane is
/// seen edge-on. The id must be a triangle of the scene.
std::optional<Homography<double>> texels_from_raster(const Scene& scene, const View& view,
                                                     std::uint32_t triangle);

/// The map of texels_from_raster(), but affine between the corners of what is left in front of the near
/// plane. That part is cut into the fan of its first corner; the triangle of the fan that holds the raster
/// position counts. w is 1.
std::optional<Homography<double>> affine_texels_from_raster(const Scene& scene, const View& view,
                                                            std::uint32_t triangle,
                                                            const glm::dvec2& p_raster);

/// The material of a triangle.
const Material& material_of(const Scene& scene, std::uint32_t triangle);

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
