/// A plane seen in perspective: two coordinates of it as quotients of affine functionals of the raster
/// position.
#pragma once

#include <array>

#include "math/affine.h"

namespace zproof {

/// (u, v) = (U(x, y), V(x, y)) / W(x, y). Of a triangle with texture coordinates, W is 1 / depth times a
/// constant: positive wherever the plane lies before the eye (Heckbert 1989, 2.1).
template <class Number>
struct Homography {
    Affine<Number> u, v, w;

    std::array<Number, 2> at(const Number& x, const Number& y) const {
        const Number weight = w.at(x, y);
        return {u.at(x, y) / weight, v.at(x, y) / weight};
    }
};

}  // namespace zproof
