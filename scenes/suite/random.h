/// The suite's own dice: the same numbers on every machine and with every standard library.
///
/// Arguments of a function call are evaluated in no fixed order, so draw inside braces ({a.uniform(..), ...})
/// or into named variables, never twice within one pair of parentheses.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace zproof::suite {

/// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    /// A multiple of 2^-53 in [0, 1), scaled to [low, high].
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }

    /// An integer in [low, high]; the bias of the remainder is below 2^-32 for the ranges used here.
    int integer(int low, int high) {
        return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }

    /// 2^x with x about uniform in [low_exponent, high_exponent + 1): every binade is equally likely.
    double binade(int low_exponent, int high_exponent);

    glm::dvec3 in_box(const glm::dvec3& low, const glm::dvec3& high);

    /// A direction, uniform on the unit sphere.
    glm::dvec3 direction();

    /// A uniform rotation.
    glm::dmat3 rotation();

    glm::vec3 color();

  private:
    std::uint64_t state_;
};

/// 2^-53 multiple in [0, 1) that belongs to a lattice point: the same for the same point and seed.
double lattice_value(int x, int y, std::uint64_t seed);

}  // namespace zproof::suite
