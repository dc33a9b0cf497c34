// Signs of an affine function at the pixels of a tile, row by row: in single precision, from the tile's first
// pixel on.

/// More than float may put a value in the tile off, if no place in it is farther from the first in x or in y:
/// twice the four roundings of its terms, and what underflows.
constexpr double most_off(const Signed& of, double at_first) {
    constexpr double farthest = Signs::side - 1, of_terms = 0x1p-22, of_underflow = 0x1p-126;
    return of_terms * (__builtin_fabs(at_first) + farthest * (__builtin_fabs(of.a) + __builtin_fabs(of.b))) +
           of_underflow;
}

void set_signs(const Signed& of, Signs& signs) noexcept {
    constexpr int side = Signs::side;
    constexpr double rounded_up = 1 + 0x1p-22;
    const double at_first = of.a * of.left + of.b * of.top + of.c;
    const auto limit = float((of.unsure + most_off(of, at_first)) * rounded_up);
    float along_row[side];
    for (int x = 0; x < side; ++x) along_row[x] = float(of.a * x);
    for (int y = 0; y < side; ++y) {
        const auto [above, below] = beyond(along_row, float(at_first + of.b * y), limit);
        signs.above[y] = std::uint16_t(above), signs.below[y] = std::uint16_t(below);
    }
}
