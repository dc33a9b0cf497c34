// One lane: for every processor.
#include "compare/strips/kernel.h"

namespace zproof::strips::scalar {
namespace {

constexpr int lanes = 1;

using Mask = bool;
using Doubles = double;

Doubles all(double value) { return value; }
Doubles loaded(const double* values) { return *values; }
void store(Doubles values, double* to) { *to = values; }
Doubles widened(const float* values) { return *values; }
Doubles widened(const std::int32_t* values) { return *values; }
Doubles magnitude(Doubles a) { return __builtin_fabs(a); }
double chosen(Mask mask, double a, double b) { return mask ? a : b; }
double greater(double a, double b) { return b > a ? b : a; }
/// A place below one.
double at_places(const double* values, std::uint64_t) { return *values; }
Mask not_greater(Doubles a, Doubles b) { return a <= b; }
Mask less(Doubles a, Doubles b) { return a < b; }
unsigned bits_of(Mask mask) { return mask; }

using Indices = std::uint32_t;
Indices loaded(const std::uint32_t* indices) { return *indices; }
double gathered(const float* table, Indices at) { return table[at]; }

unsigned where_equal(const PrimitiveId* a, const PrimitiveId* b) {
    unsigned same = 0;
    for (int i = 0; i < 16; ++i) same |= unsigned(a[i] == b[i]) << i;
    return same;
}

unsigned where_equal(const PrimitiveId* a, PrimitiveId b) {
    unsigned same = 0;
    for (int i = 0; i < 16; ++i) same |= unsigned(a[i] == b) << i;
    return same;
}

/// Of sixteen.
unsigned where_background(const float* depth) {
    unsigned bare = 0;
    for (int i = 0; i < 16; ++i) bare |= unsigned(depth[i] == background_depth) << i;
    return bare;
}

/// Of sixteen: where a value and what is added to it lie above a limit, and where below minus that.
Beyond beyond(const float* values, float added, float limit) {
    Beyond found{};
    for (int i = 0; i < 16; ++i) {
        const float sum = values[i] + added;
        found.above |= unsigned(sum > limit) << i, found.below |= unsigned(sum < -limit) << i;
    }
    return found;
}

#include "compare/strips/kernel.inl"

}  // namespace

constinit const Kernel kernel = kernel_named("scalar");

}  // namespace zproof::strips::scalar
