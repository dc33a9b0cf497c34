#include "compare/coplanar.h"

#include <algorithm>
#include <cmath>

#include "compare/neighbourhood.h"
#include "math/interval.h"
#include "math/rational.h"

namespace zproof {

namespace {

template <class Number>
bool all_in_plane(const Corners<Number>& a, const Corners<Number>& b) {
    const Vector3<Number> normal = cross(a[1] - a[0], a[2] - a[0]);
    return std::ranges::all_of(b, [&](const Vector3<Number>& p) { return sign(dot(normal, p - a[0])) == 0; });
}

}  // namespace

bool coplanar(const CornersWorld& a, const CornersWorld& b) {
    try {
        return all_in_plane(corners<Interval>(a), corners<Interval>(b));
    } catch (const UndecidedSign&) {
        return all_in_plane(corners<Rational>(a), corners<Rational>(b));
    }
}

}  // namespace zproof
