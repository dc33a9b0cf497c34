#include "scenes/shrink/digits.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace zproof::shrinking {

int digits_of(double value) {
    int exponent = 0;
    const auto mantissa = std::uint64_t(std::ldexp(std::abs(std::frexp(value, &exponent)), 53));
    return mantissa == 0 ? 0 : 53 - std::countr_zero(mantissa);
}

double rounded_to(double value, int digits) {
    if (digits == 0) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, digits)), exponent - digits);
}

}  // namespace zproof::shrinking
