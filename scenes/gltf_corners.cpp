#include "scenes/gltf_corners.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "scenes/refusal.h"

namespace zproof {
namespace {

/// The corners of triangle i (glTF 2.0, 3.7.2.1). A strip's odd triangles have their last two corners
/// swapped, so that all wind alike; a fan's triangle ends in the hub.
glm::uvec3 corners_of(int mode, std::uint32_t i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return {i, i + 1 + i % 2, i + 2 - i % 2};
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {i + 1, i + 2, 0};
    return {3 * i, 3 * i + 1, 3 * i + 2};
}

/// The indices in use, ascending and once each; `indices` then count within them.
std::vector<std::uint32_t> compact(std::vector<std::uint32_t>& indices) {
    std::vector<std::uint32_t> used = indices;
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (std::uint32_t& index : indices)
        index = static_cast<std::uint32_t>(std::ranges::lower_bound(used, index) - used.begin());
    return used;
}

}  // namespace

std::uint64_t triangle_count(int mode, std::uint64_t corners) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return corners / 3;
    const bool is_run = mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
    return is_run && corners > 2 ? corners - 2 : 0;
}

std::vector<std::uint32_t> Unroller::indices_of(const tinygltf::Primitive& primitive,
                                                std::uint32_t vertex_count) {
    std::vector<std::uint32_t> indices;
    if (primitive.indices < 0) {
        indices.resize(vertex_count);
        std::iota(indices.begin(), indices.end(), 0u);
        return indices;
    }
    const Elements& elements = accessors_.elements(primitive.indices);
    indices.resize(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
        indices[i] = index_at(elements, i);
        if (indices[i] >= vertex_count)
            refuse(model_.file, "/accessors/" + std::to_string(primitive.indices),
                   "index " + std::to_string(indices[i]) + " at " + std::to_string(i) +
                       "; expected indices below " + std::to_string(vertex_count) +
                       ", the number of vertices");
    }
    return indices;
}

Corners Unroller::unroll(const tinygltf::Primitive& primitive, std::uint32_t vertex_count) {
    std::vector<std::uint32_t> indices = indices_of(primitive, vertex_count);
    Corners corners;
    if (indices.size() < vertex_count) corners.used = compact(indices);
    corners.triangles.resize(triangle_count(primitive.mode, indices.size()));
    for (std::uint32_t i = 0; i < corners.triangles.size(); ++i) {
        const glm::uvec3 at = corners_of(primitive.mode, i);
        corners.triangles[i] = {indices[at.x], indices[at.y], indices[at.z]};
    }
    return corners;
}

}  // namespace zproof
