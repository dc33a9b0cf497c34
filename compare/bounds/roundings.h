/// What roundings cost in a declared arithmetic.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "frame/precision.h"
#include "math/rounding.h"

namespace zproof {

inline double unit_of(Arithmetic arithmetic) {
    return arithmetic == Arithmetic::float32 ? unit_roundoff_float32 : unit_roundoff_float64;
}

/// gamma(k) for the small k that every triangle asks for.
class Gammas {
  public:
    constexpr explicit Gammas(double unit) {
        for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = gamma(int(k), unit);
    }
    constexpr double operator[](std::size_t k) const { return values_[k]; }

  private:
    std::array<double, 17> values_{};
};
inline constexpr Gammas single_gammas(unit_roundoff_float32), double_gammas(unit_roundoff_float64);
inline const Gammas& gammas_of(double unit) {
    return unit == unit_roundoff_float32 ? single_gammas : double_gammas;
}
inline const Gammas& gammas_of(Arithmetic arithmetic) { return gammas_of(unit_of(arithmetic)); }

/// |a| x |b| with every term in absolute value.
inline glm::dvec3 abs_cross(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 p = glm::abs(a), q = glm::abs(b);
    return {p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
}

inline double sum_abs(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace zproof
