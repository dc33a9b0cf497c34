#include "filters/conformance/sign_probability.h"

#include <algorithm>
#include <cmath>

namespace zproof {

namespace {

/// log2 of prod (1 + exp(-2 t x)) / 2; convex in t.
double log2_bound(std::span<const double> numbers, double t) {
    double sum = 0;
    for (const double x : numbers) {
        const double y = -2 * t * x;
        sum += std::max(y, 0.0) + std::log1p(std::exp(-std::abs(y)));
    }
    return sum / std::log(2.0) - double(numbers.size());
}

}  // namespace

double log2_chance(std::span<const double> numbers) {
    double sum = 0, largest = 0;
    for (const double x : numbers) sum += x, largest = std::max(largest, std::abs(x));
    if (!(sum > 0) || !std::isfinite(largest)) return 0;
    // Any t gives a bound, so that a search that stops early errs to the side of "by chance".
    double low = 0, high = 1 / largest, best = log2_bound(numbers, high);
    for (int doublings = 0; doublings < 64; ++doublings) {
        const double next = log2_bound(numbers, 2 * high);
        if (next >= best) break;
        low = high, high *= 2, best = next;
    }
    high *= 2;
    for (int thirds = 0; thirds < 100; ++thirds) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (log2_bound(numbers, a) < log2_bound(numbers, b) ? high : low) =
            log2_bound(numbers, a) < log2_bound(numbers, b) ? b : a;
    }
    return std::min({0.0, best, log2_bound(numbers, (low + high) / 2)});
}

}  // namespace zproof
