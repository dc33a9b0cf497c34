#include "math/rounding.h"

#include <cassert>

namespace zproof {

double gamma(int k, double unit_roundoff) {
    const double ku = k * unit_roundoff;
    assert(ku < 1);
    return ku / (1 - ku);
}

}  // namespace zproof
