/// A normal map, and what of it is filtered.
///
/// Tangent space: z away from the surface, x along u, y along v. A texel's normal is constant over its
/// square.
#pragma once

#include "scenes/scene.h"
#include "texture/linear_image.h"

namespace zproof::normals {

struct NormalMap {
    int width = 0, height = 0;
    std::vector<glm::dvec3> normals;  ///< unit, z > 0, row by row

    const glm::dvec3& at(int column, int row) const {
        return normals[std::size_t(row) * std::size_t(width) + std::size_t(column)];
    }
};

/// Codes 0 to 255 are -1 to 1, not sRGB. Throws std::runtime_error where a normal points into the surface, or
/// samples are floats.
NormalMap normal_map(const Image& image);

/// The other way round: the nearest codes.
Image image_of(const NormalMap& map);

/// Bumps of falling amplitude (pink noise): the heights' slopes, by central differences.
NormalMap bumps();

/// -dz/dx and -dz/dy of the surface that has this normal: LEAN's B.
inline glm::dvec2 slope(const glm::dvec3& normal) { return {normal.x / normal.z, normal.y / normal.z}; }

/// What the models of highlight.h need, two numbers at a time: R, G, B are filtered alike.
struct FilteredImages {
    texture::LinearImage normals;  ///< x, y, z
    texture::LinearImage slopes;   ///< B.x, B.y
    texture::LinearImage squares;  ///< B.x^2, B.y^2, B.x B.y
};
FilteredImages images_to_filter(const NormalMap& map);

}  // namespace zproof::normals
