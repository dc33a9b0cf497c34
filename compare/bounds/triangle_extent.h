/// A triangle of the scene, and how far it extends.
#pragma once

#include <algorithm>
#include <array>

#include "compare/bounds/triangle_size.h"
#include "scenes/scene.h"

namespace zproof {

using CornersWorld = std::array<glm::vec3, 3>;

inline CornersWorld corners_of(const Scene& scene, std::uint32_t triangle) {
    const glm::uvec3& index = scene.triangles[triangle];
    const auto& p = scene.vertices.position_world;
    return {p[index.x], p[index.y], p[index.z]};
}

/// A triangle's corners in the number type asked for, without loss.
template <class Number>
Corners<Number> corners(const CornersWorld& p) {
    return {exactly<Number>(glm::dvec3(p[0])), exactly<Number>(glm::dvec3(p[1])),
            exactly<Number>(glm::dvec3(p[2]))};
}

/// A triangle as the error analysis sees it, the same for every renderer of a view.
struct TriangleExtent {
    std::array<glm::dvec3, 3> v_world;  ///< corner - eye
    TriangleSize size;

    /// The largest depth of a corner, in absolute value.
    double largest_depth() const {
        return std::max({std::abs(size.depth[0]), std::abs(size.depth[1]), std::abs(size.depth[2])});
    }
};

}  // namespace zproof
