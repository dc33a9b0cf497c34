/// Typed reading of accessors, and of the triangles that primitives make of them.
#pragma once

#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <vector>

#include "scenes/gltf/model.h"

namespace zproof {

/// The elements of one accessor, all readable.
struct Elements {
    const unsigned char* first = nullptr;
    std::size_t stride = 0, count = 0;
    int component_type = 0;  ///< glTF's number: 5120 BYTE to 5126 FLOAT
    int components = 0;
    bool is_normalized = false;
};

/// The size of a component of glTF's number.
std::size_t component_bytes(int component_type);

/// Component c of element i as glTF defines it: normalized integers are mapped to [0, 1] or [-1, 1].
double component(const Elements& elements, std::size_t i, int c);

constexpr int component_type_float = 5126;

inline double float_at(const unsigned char* from) {
    float value;
    std::memcpy(&value, from, sizeof value);
    return double{value};
}

/// The first three components of element i.
inline glm::dvec3 vec3_at(const Elements& elements, std::size_t i) {
    if (elements.component_type != component_type_float)
        return {component(elements, i, 0), component(elements, i, 1), component(elements, i, 2)};
    const unsigned char* from = elements.first + i * elements.stride;
    return {float_at(from), float_at(from + 4), float_at(from + 8)};
}

/// The first two components of element i.
inline glm::dvec2 vec2_at(const Elements& elements, std::size_t i) {
    if (elements.component_type != component_type_float)
        return {component(elements, i, 0), component(elements, i, 1)};
    const unsigned char* from = elements.first + i * elements.stride;
    return {float_at(from), float_at(from + 4)};
}

/// Element i of an index accessor.
std::uint32_t index_at(const Elements& elements, std::size_t i);

/// The largest of all elements of an index accessor.
std::uint32_t largest_index(const Elements& elements);

/// Elements of an index accessor, from `first` on.
void read_indices(const Elements& elements, std::size_t first, std::span<std::uint32_t> to);

/// The accessors of one model, each checked once. Keeps a reference to the model.
class Accessors {
  public:
    explicit Accessors(const GltfModel& model) : model_(model) {}

    /// Throws SceneError for numbers that are not finite, for sparse indices that do not rise or are out of
    /// range, and for sparse accessors beyond limits::sparse_bytes.
    const Elements& elements(int accessor);
    /// Elements of which some may be NaN or infinite.
    const Elements& unchecked(int accessor);
    bool is_finite(int accessor);

  private:
    Elements packed(int accessor) const;
    Elements with_sparse(int accessor, const Elements& base);
    Elements view_of(int buffer_view, std::size_t offset, const Elements& type) const;

    const GltfModel& model_;
    std::map<int, Elements> known_;
    std::map<int, bool> is_finite_;
    std::vector<Bytes> written_out_;
    std::uint64_t written_bytes_ = 0;
};

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
    Corners unroll(const gltf::Primitive& primitive, std::uint32_t vertex_count);

  private:
    void check_indices(int accessor, const Elements& elements, std::uint32_t vertex_count) const;

    const GltfModel& model_;
    Accessors& accessors_;
};

}  // namespace zproof
