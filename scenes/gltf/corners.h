/// A primitive as a list of triangles over the vertices that it uses.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scenes/gltf/accessor.h"

namespace zproof {

/// Triangles that `corners` vertices make: lists, strips and fans; 0 for points and lines. Mode is glTF's
/// number.
std::uint64_t triangle_count(int mode, std::uint64_t corners);

/// The triangles that a primitive draws, and the elements of its accessors that they use.
class Corners {
  public:
    /// Triangles from `first` on; they index into used(), or into all elements.
    void read(std::uint32_t first, std::span<glm::uvec3> to) const;
    std::uint32_t triangle_count() const { return triangles_; }
    /// The elements to bake, ascending; empty for all, in order.
    const std::vector<std::uint32_t>& used() const { return used_; }

  private:
    friend class Unroller;
    glm::uvec3 triangle(std::uint32_t i) const;
    std::uint32_t index(std::uint32_t corner) const;

    int mode_ = 0;
    std::uint32_t triangles_ = 0;
    const Elements* indices_ = nullptr;  ///< as the file has them; none: every element once
    std::vector<std::uint32_t> used_, within_used_;
};

/// Unrolls a primitive of `mode`. Where it uses few of its elements only those are kept (primitives often
/// share one large accessor). Throws SceneError for an index that is not below vertex_count. The accessors
/// must outlive the corners.
class Unroller {
  public:
    Unroller(const GltfModel& model, Accessors& accessors) : model_(model), accessors_(accessors) {}
    Corners unroll(const tinygltf::Primitive& primitive, std::uint32_t vertex_count);

  private:
    void check_indices(int accessor, const Elements& elements, std::uint32_t vertex_count) const;

    const GltfModel& model_;
    Accessors& accessors_;
};

}  // namespace zproof
