// One lane: for every processor.
#include "compare/strips/kernel.h"

namespace zproof::strips::scalar {
namespace {

constexpr int lanes = 1;

using Mask = bool;
using Doubles = double;

Doubles all(double value) { return value; }
Doubles counted() { return 0; }
Doubles loaded(const double* values) { return *values; }
void store(Doubles values, double* to) { *to = values; }
Doubles widened(const float* values) { return *values; }
Doubles magnitude(Doubles a) { return __builtin_fabs(a); }
Mask not_greater(Doubles a, Doubles b) { return a <= b; }
unsigned bits_of(Mask mask) { return mask; }

unsigned where_equal(const PrimitiveId* a, const PrimitiveId* b) {
    unsigned same = 0;
    for (int i = 0; i < 16; ++i) same |= unsigned(a[i] == b[i]) << i;
    return same;
}

/// Of sixteen.
unsigned where_background(const float* depth) {
    unsigned bare = 0;
    for (int i = 0; i < 16; ++i) bare |= unsigned(depth[i] == background_depth) << i;
    return bare;
}

#include "compare/strips/certain.inl"
#include "compare/strips/ids.inl"

}  // namespace

const Kernel kernel{"scalar", compare, certain};

}  // namespace zproof::strips::scalar
