/// Numbers of fewer binary digits.
#pragma once

#include <array>

namespace zproof::shrinking {

/// What is tried, the shortest first: 0 digits are the number 0.
inline constexpr std::array digit_counts{0, 1, 2, 3, 4, 6, 8, 12, 16, 24};

/// Significant binary digits: 0 of 0, 1 of a power of two.
int digits_of(double value);

/// The nearest number of at most so many digits.
double rounded_to(double value, int digits);

}  // namespace zproof::shrinking
