#include "scenes/suite/random.h"

#include <cmath>

namespace zproof::suite {

double Random::binade(int low_exponent, int high_exponent) {
    const int exponent = integer(low_exponent, high_exponent);
    return std::ldexp(uniform(1, 2), exponent);
}

glm::dvec3 Random::in_box(const glm::dvec3& low, const glm::dvec3& high) {
    return glm::dvec3{uniform(low.x, high.x), uniform(low.y, high.y), uniform(low.z, high.z)};
}

glm::dvec3 Random::direction() {
    for (;;) {
        const glm::dvec3 p = in_box(glm::dvec3(-1), glm::dvec3(1));
        const double square = glm::dot(p, p);
        if (square > 0x1p-20 && square <= 1) return p / std::sqrt(square);
    }
}

glm::dmat3 Random::rotation() {
    const glm::dvec3 x = direction();
    for (;;) {
        const glm::dvec3 hint = direction();
        const glm::dvec3 across = glm::cross(x, hint);
        const double square = glm::dot(across, across);
        if (square < 0x1p-10) continue;
        const glm::dvec3 y = across / std::sqrt(square);
        return glm::dmat3(x, y, glm::cross(x, y));
    }
}

glm::vec3 Random::color() { return glm::vec3(in_box(glm::dvec3(0.1), glm::dvec3(0.9))); }

double lattice_value(int x, int y, std::uint64_t seed) {
    const auto ux = static_cast<std::uint64_t>(x), uy = static_cast<std::uint64_t>(y);
    return Random(seed ^ (ux * 0x9E3779B97F4A7C15u) ^ (uy * 0xC2B2AE3D27D4EB4Fu)).uniform(0, 1);
}

}  // namespace zproof::suite
