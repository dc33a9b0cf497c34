/// error / bound as one byte.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace zproof::planes {

/// 0 for NaN, else 1 + what lies between 0 and 254 of the quarter octaves from 2^-50 up; so 201 is
/// [1, 2^(1/4)), and no code holds ratios of both sides of 1.
std::uint8_t error_code(float error_over_bound);

/// The codes of many, in order.
std::string error_codes(std::span<const float> errors);

}  // namespace zproof::planes
