#include "scenes/vector_block.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace zproof {
[[gnu::target_clones("default", "avx2", "avx512f")]] void VectorBlock::read(const unsigned char* packed) {
    std::array<float, 3 * capacity> numbers;
    std::memcpy(numbers.data(), packed, 3 * size_ * sizeof(float));
    for (std::size_t i = 0; i < size_; ++i) {
        x_[i] = double{numbers[3 * i]};
        y_[i] = double{numbers[3 * i + 1]};
        z_[i] = double{numbers[3 * i + 2]};
    }
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void VectorBlock::multiply(const glm::dmat3& matrix) {
    const glm::dmat3 m = matrix;
    for (std::size_t i = 0; i < size_; ++i) {
        const double x = x_[i], y = y_[i], z = z_[i];
        x_[i] = m[0].x * x + m[1].x * y + m[2].x * z;
        y_[i] = m[0].y * x + m[1].y * y + m[2].y * z;
        z_[i] = m[0].z * x + m[1].z * y + m[2].z * z;
    }
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void VectorBlock::add(const glm::dvec3& vector) {
    for (std::size_t i = 0; i < size_; ++i) {
        x_[i] += vector.x;
        y_[i] += vector.y;
        z_[i] += vector.z;
    }
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void VectorBlock::normalize() {
    for (std::size_t i = 0; i < size_; ++i) {
        const double length = std::sqrt(x_[i] * x_[i] + y_[i] * y_[i] + z_[i] * z_[i]);
        const double x = x_[i] / length, y = y_[i] / length, z = z_[i] / length;
        const bool has_direction = (length > 0) & (length <= std::numeric_limits<double>::max());
        x_[i] = has_direction ? x : 0;
        y_[i] = has_direction ? y : 0;
        z_[i] = has_direction ? z : 0;
    }
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void VectorBlock::write(std::span<glm::vec3> to) const {
    float* numbers = &to.data()->x;
    for (std::size_t i = 0; i < size_; ++i) {
        numbers[3 * i] = static_cast<float>(x_[i]);
        numbers[3 * i + 1] = static_cast<float>(y_[i]);
        numbers[3 * i + 2] = static_cast<float>(z_[i]);
    }
}

}  // namespace zproof
