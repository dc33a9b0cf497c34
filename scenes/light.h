/// The one light of a shaded picture, as plain facts.
#pragma once

#include <glm/glm.hpp>

namespace zproof {

/// A light at infinity without shadows that goes where the camera goes, so that every view is lit. A surface
/// of base colour c, whose unit normal n is turned to the viewer, shows c (ambient + diffuse max(0, n . l)).
struct Light {
    glm::dvec3 toward_camera{0.36, 0.48,
                             0.8};  ///< l: unit, camera space (x right, y up, z towards the viewer)
    double ambient = 0.25, diffuse = 0.75;
};

}  // namespace zproof
