#include "scenes/gltf/corners.h"

#include <algorithm>
#include <string>
#include <utility>

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

/// The indices in use, ascending and once each.
std::vector<std::uint32_t> in_use(std::vector<std::uint32_t> indices) {
    std::ranges::sort(indices);
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

}  // namespace

std::uint64_t triangle_count(int mode, std::uint64_t corners) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return corners / 3;
    const bool is_run = mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
    return is_run && corners > 2 ? corners - 2 : 0;
}

void Corners::read(std::uint32_t first, std::span<glm::uvec3> to) const {
    if (mode_ == TINYGLTF_MODE_TRIANGLES && indices_ != nullptr && within_used_.empty())
        return read_indices(*indices_, 3 * std::size_t{first}, {&to.data()->x, 3 * to.size()});
    for (std::uint32_t i = 0; i < to.size(); ++i) to[i] = triangle(first + i);
}

glm::uvec3 Corners::triangle(std::uint32_t i) const {
    const glm::uvec3 at = corners_of(mode_, i);
    return {index(at.x), index(at.y), index(at.z)};
}

std::uint32_t Corners::index(std::uint32_t corner) const {
    if (!within_used_.empty()) return within_used_[corner];
    return indices_ == nullptr ? corner : index_at(*indices_, corner);
}

void Unroller::check_indices(int accessor, const Elements& elements, std::uint32_t vertex_count) const {
    if (largest_index(elements) < vertex_count) return;
    std::size_t bad = 0;
    while (index_at(elements, bad) < vertex_count) ++bad;
    refuse(model_.file, "/accessors/" + std::to_string(accessor),
           "index " + std::to_string(index_at(elements, bad)) + " at " + std::to_string(bad) +
               "; expected indices below " + std::to_string(vertex_count) + ", the number of vertices");
}

Corners Unroller::unroll(const tinygltf::Primitive& primitive, std::uint32_t vertex_count) {
    Corners corners;
    corners.mode_ = primitive.mode;
    corners.triangles_ = static_cast<std::uint32_t>(zproof::triangle_count(primitive.mode, vertex_count));
    if (primitive.indices < 0) return corners;
    const Elements& elements = accessors_.elements(primitive.indices);
    check_indices(primitive.indices, elements, vertex_count);
    corners.triangles_ = static_cast<std::uint32_t>(zproof::triangle_count(primitive.mode, elements.count));
    corners.indices_ = &elements;
    if (elements.count >= vertex_count) return corners;
    std::vector<std::uint32_t> indices(elements.count);
    read_indices(elements, 0, indices);
    corners.used_ = in_use(indices);
    for (std::uint32_t& index : indices)
        index = static_cast<std::uint32_t>(std::ranges::lower_bound(corners.used_, index) -
                                           corners.used_.begin());
    corners.within_used_ = std::move(indices);
    return corners;
}

}  // namespace zproof
