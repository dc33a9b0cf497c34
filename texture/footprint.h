/// What a pixel covers of a texture. Texel coordinates are those of level 0: texel i covers [i, i + 1).
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "math/affine.h"

namespace zproof::texture {

/// How the steps per pixel are known.
enum class Derivatives {
    analytic,          ///< of the homography, at the pixel's centre
    quad_differences,  ///< between the centres of the aligned 2 x 2 pixels that hold the pixel, its own row
                       ///< and column
};

/// What the cone about the pixel's ray covers of the surface's plane, as an ellipse: Akenine-Moller, Crassin,
/// Boksansky, Belcour, Panteleev and Wright 2021, with their erratum. A footprint that knows of no ray has
/// none: both axes are 0.
struct ConeEllipse {
    glm::dvec2 along{0};   ///< semi-axis along the ray's projection onto the surface, texels
    glm::dvec2 across{0};  ///< semi-axis at right angles to that on the surface: the cone's radius, texels
    double cosine = 1;     ///< of the angle between the ray and the surface's normal, in (0, 1]
};

struct Footprint {
    glm::dvec2 centre{0};  ///< seen through the pixel's centre, texels
    glm::dvec2 per_x{0},
        per_y{0};                 ///< texels per step of one pixel in raster x and y: the Jacobian's columns
    ConeEllipse cone{};           ///< of the pixel's ray
    glm::dvec2 centre_raster{0};  ///< the pixel's centre, pixels
    Homography<double> texels_from_raster{};  ///< all of the surface's plane, for methods that ask for more

    /// Seen through any raster position; not finite on the plane's horizon.
    glm::dvec2 at(const glm::dvec2& p_raster) const {
        const auto [u, v] = texels_from_raster.at(p_raster.x, p_raster.y);
        return {u, v};
    }
};

/// The footprint of pixel (x, y), without the cone of its ray.
Footprint footprint(const Homography<double>& texels_from_raster, int x, int y, Derivatives derivatives);

/// The pixel's corners on the texture, round the pixel: (x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1).
std::array<glm::dvec2, 4> corners(const Footprint& footprint);

/// Singular values of the Jacobian [per_x per_y]: the semi-axes of the image of the unit circle, texels, and
/// the unit direction of the longer one ((1, 0) where both are equal). Heckbert 1989, 3.5.
struct Ellipse {
    double major = 0, minor = 0;
    glm::dvec2 major_direction{1, 0};
};
Ellipse ellipse(const Footprint& footprint);

}  // namespace zproof::texture
