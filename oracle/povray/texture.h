/// A material's base colour as an image that POV-Ray reads as it is.
///
/// POV-Ray's bilinear interpolation (`interpolate 2`) has texel centres where OpenGL has them and repeats the
/// image without end, v upwards. So an axis that repeats is left alone; one that clamps or mirrors is
/// unrolled as far as the scene's coordinates reach.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scenes/scene.h"

namespace zproof::oracle {

/// One axis of an image: texels first, first + 1, ..., first + count - 1, beyond the stored ones by the wrap.
struct UnrolledAxis {
    int first = 0, count = 1;
    int size = 1;  ///< of the stored image

    /// The place on the unrolled image, which is 1 long.
    double place(double coordinate) const { return (coordinate * size - first) / count; }
};

struct PovrayTexture {
    UnrolledAxis u, v;
    std::string png;  ///< the file: 16 bits, linear light: texel times base colour factor

    /// POV-Ray's coordinates of a glTF place.
    glm::dvec2 uv(const glm::dvec2& gltf) const { return {u.place(gltf.x), 1 - v.place(gltf.y)}; }
};

/// Texture coordinates that are used, after the material's transform.
struct UvRange {
    glm::dvec2 lowest{0}, highest{0};
};

/// The material must have an image. Throws OracleError where the range is more than 16 images long on an axis
/// that does not repeat.
PovrayTexture povray_texture(const Scene& scene, const Material& material, const UvRange& range);

}  // namespace zproof::oracle
