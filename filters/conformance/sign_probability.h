/// How improbable it is that independent errors, none of which prefers to be positive, are so positive
/// together.
#pragma once

#include <span>

namespace zproof {

/// Base-2 logarithm of a bound on the probability of a sum as large as that of these numbers, or larger.
///
/// Null hypothesis: the numbers are independent, and each is symmetric about a mean of at most 0. At a mean
/// of 0, given their absolute values, the signs are fair coins, so for every t >= 0 (Chernoff 1952; E exp(t s
/// |x|) = cosh(t |x|))
///
///     P(sum >= sum x) <= exp(-t sum x) prod cosh(t |x|) = prod (1 + exp(-2 t x)) / 2.
///
/// The least over t is taken. The right side falls in every x, so means below 0 only make it larger. No scale
/// of the numbers is assumed: n positive numbers have 2^-n. The result is at most 0.
double log2_chance(std::span<const double> numbers);

}  // namespace zproof
