/// A thousand vectors at a time.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>

namespace zproof {

/// Vectors that are transformed side by side, each with the bits that GLM gives it alone.
class VectorBlock {
  public:
    static constexpr std::size_t capacity = 1024;

    struct Coordinates {
        std::size_t size;
        std::array<double, capacity> x, y, z;
    };

    /// The block has `size` vectors, at most `capacity`, without values yet.
    explicit VectorBlock(std::size_t size) { all_.size = size; }

    void set(std::size_t i, const glm::dvec3& vector) {
        all_.x[i] = vector.x;
        all_.y[i] = vector.y;
        all_.z[i] = vector.z;
    }

    /// Takes them from packed floats.
    void read(const unsigned char* packed);
    void multiply(const glm::dmat3& matrix);
    void add(const glm::dvec3& vector);
    /// To each the vector that has its place in the other block, of the same size, times the weight.
    void add(double weight, const VectorBlock& other);
    /// Divides each by its length; those without a direction (length 0, infinite or no number) become 0.
    void normalize();
    /// Writes all vectors, each rounded once.
    void write(std::span<glm::vec3> to) const;

  private:
    Coordinates all_;
};

}  // namespace zproof
