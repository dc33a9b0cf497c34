/// Doubles that try hard: every magnitude, subnormals, zeros, neighbours of powers of two.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace zproof {

/// Zeros, the least and greatest, powers of two and their neighbours, both signs; all finite.
std::vector<double> hard_doubles();

/// A finite double of either sign: uniform exponent from 2^lowest to 2^highest, random digits.
double random_double(std::mt19937_64& random, int lowest = -1074, int highest = 1023);

}  // namespace zproof
