/// Affine functionals of the image plane, and the lines on which they vanish.
#pragma once

#include <array>

namespace zproof {

/// value(x, y) = a x + b y + c; x and y in pixels.
template <class Number>
struct Affine {
    Number a, b, c;

    Number at(const Number& x, const Number& y) const { return a * x + b * y + c; }
    friend Affine operator-(const Affine& f) { return {-f.a, -f.b, -f.c}; }
    friend Affine operator+(const Affine& f, const Affine& g) { return {f.a + g.a, f.b + g.b, f.c + g.c}; }
    friend Affine operator-(const Affine& f, const Affine& g) { return {f.a - g.a, f.b - g.b, f.c - g.c}; }
    friend Affine operator*(const Number& s, const Affine& f) { return {s * f.a, s * f.b, s * f.c}; }
};

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
