/// Affine functionals of the image plane, and the lines on which they vanish.
#pragma once

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

}  // namespace zproof
