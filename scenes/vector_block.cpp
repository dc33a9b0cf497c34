#include "scenes/vector_block.h"

#include <cmath>
#include <limits>

namespace zproof {

void VectorBlock::multiply(const glm::dmat3& m) {
    for (std::size_t i = 0; i < size_; ++i) {
        const double x = x_[i], y = y_[i], z = z_[i];
        x_[i] = m[0][0] * x + m[1][0] * y + m[2][0] * z;
        y_[i] = m[0][1] * x + m[1][1] * y + m[2][1] * z;
        z_[i] = m[0][2] * x + m[1][2] * y + m[2][2] * z;
    }
}

void VectorBlock::add(const glm::dvec3& vector) {
    for (std::size_t i = 0; i < size_; ++i) {
        x_[i] += vector.x;
        y_[i] += vector.y;
        z_[i] += vector.z;
    }
}

void VectorBlock::normalize() {
    for (std::size_t i = 0; i < size_; ++i) {
        const double length = std::sqrt(x_[i] * x_[i] + y_[i] * y_[i] + z_[i] * z_[i]);
        const double x = x_[i] / length, y = y_[i] / length, z = z_[i] / length;
        const bool has_direction = (length > 0) & (length <= std::numeric_limits<double>::max());
        x_[i] = has_direction ? x : 0;
        y_[i] = has_direction ? y : 0;
        z_[i] = has_direction ? z : 0;
    }
}

void VectorBlock::write(std::span<glm::vec3> to) const {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = {x_[i], y_[i], z_[i]};
}

}  // namespace zproof
