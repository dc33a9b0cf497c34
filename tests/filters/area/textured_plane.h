/// A textured ground for tests of area integrals.
#pragma once

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// Grey texels, row 0 first; 0 black, 255 white.
Image image_of(int width, int height, const std::vector<std::uint8_t>& grey);

/// Checks of `check` texels, white first.
Image checks(int side, int check);

/// 0 and 255 at random.
Image noise(int width, int height, std::uint32_t seed);

/// The plane y = 0 from -reach to reach in x and z as two triangles; uv are (x, z) times `per_unit`, turned
/// by phi about the origin, plus offset.
struct PlaneTexture {
    Image image;
    double per_unit = 1, phi_degrees = 0;
    glm::dvec2 offset{0};
    Wrap wrap = Wrap::repeat;
};
Scene textured_plane(float reach, const PlaneTexture& texture);

/// From height 1, pitched down, looking along -z; 60 degrees high.
View ground_view(int width, int height, double pitch_degrees);

}  // namespace zproof::oracle
