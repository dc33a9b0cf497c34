#include "scenes/suite/unit_circle.h"

#include <cmath>

namespace zproof::suite {

namespace {

/// The Taylor series at |angle| <= pi/4: the first term left out is below (pi/4)^19 / 19! < 1e-19.
glm::dvec2 near_zero(double angle) {
    const double square = angle * angle;
    double cosine = 1, sine = 1;
    for (int n = 18; n >= 2; n -= 2) {
        cosine = 1 - cosine * square / (n * (n - 1));
        sine = 1 - sine * square / (n * (n + 1));
    }
    return {cosine, sine * angle};
}

}  // namespace

glm::dvec2 unit_circle(double turns) {
    const double quarters = std::floor(4 * turns + 0.5);
    const double two_pi = 6.283185307179586477;
    const glm::dvec2 p = near_zero((turns - quarters / 4) * two_pi);
    switch (static_cast<long long>(quarters) & 3) {
        case 0:
            return p;
        case 1:
            return {-p.y, p.x};
        case 2:
            return {-p.x, -p.y};
        default:
            return {p.y, -p.x};
    }
}

}  // namespace zproof::suite
