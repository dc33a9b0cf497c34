/// How much light a point sends to the eye: Lambert's diffuse part and a highlight.
#pragma once

#include <glm/glm.hpp>

namespace zproof::study::shading {

enum class Highlight {
    phong,        ///< (r . v)^exponent, r the light's direction mirrored at the normal (Phong 1975)
    blinn_phong,  ///< (n . h)^exponent, h half way between light and eye (Blinn 1977)
};

/// Shares of the light; a surface of colour 1. What a material's colour would multiply is left out, for it
/// multiplies every method alike.
struct Finish {
    double ambient = 0.1, diffuse = 0.6, specular = 0.3, exponent = 40;
    Highlight highlight = Highlight::phong;
};

/// White, without shadows and without falling off.
struct LightSource {
    enum class Kind { directional, point };
    Kind kind = Kind::directional;
    glm::dvec3 world{0, 0, 1};  ///< unit, towards the light; or the light's place

    glm::dvec3 toward(const glm::dvec3& p_world) const {
        return kind == Kind::directional ? world : glm::normalize(world - p_world);
    }
};

/// A place on a surface, its unit normal, and the unit direction to the eye.
struct SurfacePoint {
    glm::dvec3 p_world{0}, normal{0, 0, 1}, toward_eye{0, 0, 1};
};

/// ambient + diffuse max(0, n . l) + specular max(0, cosine)^exponent; no highlight where n . l <= 0.
double intensity(const SurfacePoint& surface_point, const LightSource& light_source, const Finish& finish);

}  // namespace zproof::study::shading
