#include "doubles.h"

#include <cmath>
#include <limits>

namespace zproof {

std::vector<double> hard_doubles() {
    using Limits = std::numeric_limits<double>;
    std::vector<double> values;
    for (const double v : {0.0, Limits::denorm_min(), 3 * Limits::denorm_min(), Limits::min(), 1e-300,
                           0x1p-537, 0.1, 1.0, 3.0, 0x1p511, 1e300, Limits::max()})
        for (const double neighbour : {std::nextafter(v, 0.0), v, std::nextafter(v, Limits::max())}) {
            values.push_back(neighbour);
            values.push_back(-neighbour);
        }
    return values;
}

double random_double(std::mt19937_64& random, int lowest, int highest) {
    const double digits = 1 + double(random() >> 12) * 0x1p-52;
    const int exponent = lowest + int(random() % std::uint64_t(highest - lowest + 1));
    return std::ldexp(random() % 2 ? digits : -digits, exponent);
}

}  // namespace zproof
