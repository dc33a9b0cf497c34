/// What each pixel's centre sees of a texture, for telling regions apart and for asking samplers.
#pragma once

#include <vector>

#include "frame/frame.h"
#include "scenes/scene.h"
#include "scenes/view.h"
#include "texture/footprint.h"

namespace zproof::study {

/// The footprint and its ellipse; all 0 where there is no texture.
struct Patch {
    double major = 0, minor = 0;    ///< semi-axes, texels of level 0 per pixel
    double angle_degrees = 0;       ///< of the major axis to the nearer of +u and -u, 0 to 90
    int longest_side = 0;           ///< of the texture, texels
    double lod = 0;                 ///< of OpenGL (filters/methods/lod.h), neither biased nor clamped
    glm::dvec2 centre{0};           ///< texels
    glm::dvec2 per_x{0}, per_y{0};  ///< texels per pixel: the Jacobian's columns

    bool is_textured() const { return longest_side > 0; }
};

/// The ellipse of every pixel's footprint, by the analytic Jacobian at the pixel's centre.
Plane<Patch> surface_map(const Scene& scene, const View& view, const Frame& frame);

/// A texture to be read at a place.
struct Lookup {
    int material = 0;
    texture::Footprint footprint;
};

/// The lookups of the picture in raster order; of more than `most`, each k-th with the least whole k that
/// keeps to it.
std::vector<Lookup> lookups(const Scene& scene, const View& view, const Frame& frame, std::size_t most);

}  // namespace zproof::study
