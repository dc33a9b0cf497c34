/// A primitive as a list of triangles over the vertices that it uses.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scenes/gltf_accessor.h"

namespace zproof {

/// Triangles that `corners` vertices make: lists, strips and fans; 0 for points and lines. Mode is glTF's
/// number.
std::uint64_t triangle_count(int mode, std::uint64_t corners);

struct Corners {
    std::vector<std::uint32_t> used;    ///< the elements to bake, ascending; empty for all, in order
    std::vector<glm::uvec3> triangles;  ///< indices into `used`, or into all elements
};

/// Unrolls a primitive of `mode`. Where it uses few of its elements only those are kept (primitives often
/// share one large accessor). Throws SceneError for an index that is not below vertex_count.
class Unroller {
  public:
    Unroller(const GltfModel& model, Accessors& accessors) : model_(model), accessors_(accessors) {}
    Corners unroll(const tinygltf::Primitive& primitive, std::uint32_t vertex_count);

  private:
    std::vector<std::uint32_t> indices_of(const tinygltf::Primitive& primitive, std::uint32_t vertex_count);

    const GltfModel& model_;
    Accessors& accessors_;
};

}  // namespace zproof
