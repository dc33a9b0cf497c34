#include "scenes/vector_block.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "math/widest.h"

namespace zproof {
namespace {

using Coordinates = VectorBlock::Coordinates;

void read_packed(Coordinates& to, const unsigned char* packed) {
    std::array<float, 3 * VectorBlock::capacity> numbers;
    std::memcpy(numbers.data(), packed, 3 * to.size * sizeof(float));
    for (std::size_t i = 0; i < to.size; ++i) {
        to.x[i] = double{numbers[3 * i]};
        to.y[i] = double{numbers[3 * i + 1]};
        to.z[i] = double{numbers[3 * i + 2]};
    }
}

void multiply_all(Coordinates& all, const glm::dmat3& matrix) {
    const glm::dmat3 m = matrix;
    for (std::size_t i = 0; i < all.size; ++i) {
        const double x = all.x[i], y = all.y[i], z = all.z[i];
        all.x[i] = m[0].x * x + m[1].x * y + m[2].x * z;
        all.y[i] = m[0].y * x + m[1].y * y + m[2].y * z;
        all.z[i] = m[0].z * x + m[1].z * y + m[2].z * z;
    }
}

void add_to_all(Coordinates& all, const glm::dvec3& vector) {
    for (std::size_t i = 0; i < all.size; ++i) {
        all.x[i] += vector.x;
        all.y[i] += vector.y;
        all.z[i] += vector.z;
    }
}

void add_weighted(Coordinates& all, double weight, const Coordinates& other) {
    for (std::size_t i = 0; i < all.size; ++i) {
        all.x[i] += weight * other.x[i];
        all.y[i] += weight * other.y[i];
        all.z[i] += weight * other.z[i];
    }
}

void normalize_all(Coordinates& all) {
    for (std::size_t i = 0; i < all.size; ++i) {
        const double length = std::sqrt(all.x[i] * all.x[i] + all.y[i] * all.y[i] + all.z[i] * all.z[i]);
        const double x = all.x[i] / length, y = all.y[i] / length, z = all.z[i] / length;
        const bool has_direction = (length > 0) & (length <= std::numeric_limits<double>::max());
        all.x[i] = has_direction ? x : 0;
        all.y[i] = has_direction ? y : 0;
        all.z[i] = has_direction ? z : 0;
    }
}

void write_all(const Coordinates& all, float* numbers) {
    for (std::size_t i = 0; i < all.size; ++i) {
        numbers[3 * i] = static_cast<float>(all.x[i]);
        numbers[3 * i + 1] = static_cast<float>(all.y[i]);
        numbers[3 * i + 2] = static_cast<float>(all.z[i]);
    }
}

}  // namespace

void VectorBlock::read(const unsigned char* packed) { widest<read_packed>(all_, packed); }
void VectorBlock::multiply(const glm::dmat3& matrix) { widest<multiply_all>(all_, matrix); }
void VectorBlock::add(const glm::dvec3& vector) { widest<add_to_all>(all_, vector); }
void VectorBlock::add(double weight, const VectorBlock& other) {
    widest<add_weighted>(all_, weight, other.all_);
}
void VectorBlock::normalize() { widest<normalize_all>(all_); }
void VectorBlock::write(std::span<glm::vec3> to) const { widest<write_all>(all_, &to.data()->x); }

}  // namespace zproof
