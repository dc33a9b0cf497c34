/// The lecture's three ways from corners to pixels.
#pragma once

#include <array>

#include "frame/frame.h"
#include "lessons/shading/reflection.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::study::shading {

enum class Method {
    faceted,  ///< one normal for a triangle, its plane's; shaded once, at its centroid
    gouraud,  ///< the corners are shaded, what they send is interpolated (Gouraud 1971)
    phong,    ///< the corners' normals are interpolated, every pixel is shaded (Phong 1975)
};

/// The weights by which corners are mixed.
enum class Mixing {
    perspective,  ///< barycentrics of the place on the triangle
    affine,       ///< barycentrics of the place in the image: as if there were no perspective
};

inline constexpr std::array all_methods{Method::faceted, Method::gouraud, Method::phong};
const char* name_of(Method method);
const char* name_of(Mixing mixing);
const char* name_of(Highlight highlight);

/// How light falls on a scene.
struct Lighting {
    LightSource light_source;
    Finish finish;
};

/// A visible triangle. Normals are the corners' own where all three have one, else the plane's;
/// turned over where the triangle's back is seen.
struct Facet {
    std::array<glm::dvec3, 3> p_world, normal;  ///< normals: not of unit length
    glm::dvec3 face_normal{0};                  ///< unit, towards the eye; 0 where there is no area
};
Facet facet_of(const Scene& scene, const View& view, std::uint32_t triangle);

using Weights = std::array<double, 3>;  ///< they add up to 1

/// What the pixel gets, by weights of the place on the triangle. The eye looks from view.camera.
double shaded(const Facet& facet, const View& view, const Lighting& lighting, Method method,
              const Weights& weights);

/// Two functions that share no code find where the view ray through a pixel's centre meets the triangle.
/// The rasterizer's: barycentrics from the frame's arithmetic (rasterizer/surface.h).
Weights rasterized_weights(const View& view, const Facet& facet, int x, int y);
/// The oracle's: the hit's place in space, then areas beside it.
Weights traced_weights(const View& view, const Facet& facet, int x, int y);

/// The weights in the image: each weight times its corner's depth, brought to a sum of 1.
Weights in_image(const View& view, const Facet& facet, const Weights& weights);

/// Who says where a pixel's place on its triangle is.
using WeightRule = Weights (*)(const View&, const Facet&, int, int);

/// What is asked of a picture.
struct Technique {
    Method method = Method::phong;
    Mixing mixing = Mixing::perspective;
    WeightRule rule = rasterized_weights;
};

/// Every pixel that the frame names a triangle for; NaN elsewhere. Perspective views only are affected by
/// mixing.
Plane<double> picture(const Scene& scene, const View& view, const Frame& frame, const Lighting& lighting,
                      const Technique& technique);

}  // namespace zproof::study::shading
