// Signs of an affine function at the pixels of a tile, row by row.

void set_signs(const Signed& of, Signs& signs) noexcept {
    constexpr int side = Signs::side;
    const Doubles c = all(of.c), from = all(of.unsure), up_to = all(-of.unsure);
    const Columns columns(of.left);
    double along_row[side];
    for (int x = 0; x < side; x += lanes) store(all(of.a) * columns.from(x), along_row + x);
    for (int y = 0; y < side; ++y) {
        const Doubles along_column = all(of.b * (of.top + y));
        unsigned above = 0, below = 0;
        for (int x = 0; x < side; x += lanes) {
            const Doubles middle = loaded(along_row + x) + along_column + c;
            above |= bits_of(less(from, middle)) << x;
            below |= bits_of(less(middle, up_to)) << x;
        }
        signs.above[y] = std::uint16_t(above), signs.below[y] = std::uint16_t(below);
    }
}
