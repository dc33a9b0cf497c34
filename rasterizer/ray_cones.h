/// The cones about the rays of a view, and what they cover of a triangle's texture. Akenine-Moller, Nilsson,
/// Andersson, Barre-Brisebois, Toth and Karras 2019; Akenine-Moller, Crassin, Boksansky, Belcour, Panteleev
/// and Wright 2021, with their erratum: w = 2 t tan(alpha / 2).
#pragma once

#include "rasterizer/surface.h"
#include "rasterizer/texel_map.h"
#include "texture/footprint.h"

namespace zproof::rasterizer {

class RayCones {
  public:
    RayCones(const View& view, const std::array<TexturedCorner, 3>& corners);

    /// Where the cone about the ray of a raster position meets the triangle's plane. Not finite where the ray
    /// runs along the plane.
    texture::ConeEllipse at(const glm::dvec2& p_raster) const;

  private:
    /// A vector in the triangle's plane, as a step on the texture.
    glm::dvec2 texels(const glm::dvec3& in_plane) const {
        return {glm::dot(u_gradient_, in_plane), glm::dot(v_gradient_, in_plane)};
    }

    PixelRays rays_;
    Projection projection_;
    double radius_;  ///< at distance 1 in perspective: tan(alpha / 2); else everywhere, scene units
    glm::dvec3 normal_, any_direction_;   ///< units; the direction lies in the plane
    glm::dvec3 u_gradient_, v_gradient_;  ///< texels per scene unit, in the plane
    double plane_distance_;               ///< from the eye, along the normal
};

}  // namespace zproof::rasterizer
