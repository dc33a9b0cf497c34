/// The binary chunk of a GLB while it grows, with the bufferViews and accessors that describe it.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace zproof {

/// How the elements of an accessor are read: glTF 2.0, section 5.1.
struct ElementType {
    int component_type = 5126;  ///< 5126 FLOAT, 5125 UNSIGNED_INT
    std::string_view type;      ///< "SCALAR", "VEC2", "VEC3", "VEC4"
    std::size_t bytes = 0;      ///< of one element
};

/// A run of elements within a bufferView.
struct ElementRange {
    std::size_t first = 0, count = 0;
};

class GlbBuffer {
  public:
    /// Appends bytes at a multiple of 4 and returns the index of their bufferView; `extra` holds target or
    /// byteStride.
    int add_view(std::string_view bytes, const nlohmann::json& extra);

    /// Describes elements of a bufferView and returns the index of the accessor.
    int add_accessor(int view, const ElementType& element, ElementRange range);

    /// As above with the componentwise bounds, which positions must have.
    int add_bounded_accessor(int view, ElementRange range, std::span<const float> low,
                             std::span<const float> high);

    const std::string& bytes() const { return bytes_; }
    const nlohmann::json& views() const { return views_; }
    const nlohmann::json& accessors() const { return accessors_; }

  private:
    std::string bytes_;
    nlohmann::json views_ = nlohmann::json::array(), accessors_ = nlohmann::json::array();
};

/// The bytes of a span of plain elements as they lie in memory; glTF wants little-endian.
template <class Element>
std::string_view bytes_of(std::span<const Element> elements) {
    return {reinterpret_cast<const char*>(elements.data()), elements.size_bytes()};
}

}  // namespace zproof
