// Which pixels of a tile one triangle covers: cells of 16 x 16 pixels, or one square of that size, then their
// blocks of 4 x 4, then the pixels of a block. Sixteen of each are asked side by side in 32-bit integers:
// lane i is column i % 4, row i / 4.
//
// Where |F| at a square's first pixel is 2^30 or more, F has one sign in all of it: points of the guard band
// differ by 2^25 at most (kernel.inl), so fifteen columns and fifteen rows add less than 2^30. There +-2^30
// serves for F, and every sum stays below 2^31.

constexpr double most_of_f = 0x1p30;
constexpr int square_side = 16;  ///< pixels

alignas(64) constexpr std::int32_t lane_column[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr std::int32_t lane_row[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

alignas(64) constexpr double cell_x[16] = {0, 16, 32, 48, 0, 16, 32, 48, 0, 16, 32, 48, 0, 16, 32, 48};
alignas(64) constexpr double cell_y[16] = {0, 0, 0, 0, 16, 16, 16, 16, 32, 32, 32, 32, 48, 48, 48, 48};

/// 16 x 16 pixels of the tile.
struct Square {
    int x, y;                                  ///< the first
    std::int32_t f[3];                         ///< F there, or +-2^30
    unsigned met;                              ///< blocks that may have covered pixels, bit by bit
    bool is_whole;                             ///< all of its pixels are covered
    alignas(64) std::int32_t of_block[3][16];  ///< F at the blocks' first pixels; nothing where it is whole
};

/// The tile's cells.
struct Cells {
    alignas(64) std::int32_t f[3][16];  ///< F at their first pixels, or +-2^30
    unsigned met, whole;                ///< that may have covered pixels, that have no others; bit by bit
};

/// The edges of one triangle.
struct Cover {
    alignas(64) std::int32_t of_pixel[3][16];  ///< F from the first pixel of a block to each
    alignas(64) std::int32_t of_block[3][16];  ///< four times that, from the first block of a square to each
    std::int32_t inwards[3], outwards[3];      ///< F from a block's first pixel to its greatest, its least
    double f[3], to_column[3], to_row[3];      ///< F at the tile's first pixel, and its steps

    Cover(const Edges& edges, int i);
    Cells cells() const;
    void set_to_cell(Square& square, const Cells& cells, int cell) const;
    void set_to_pixels_from(Square& square, int x, int y) const;
    /// Negative where a pixel is not covered.
    Ints inside(const Square& square, int block) const {
        const auto edge = [&](int k) { return load(of_pixel[k]) + splat(square.of_block[k][block]); };
        return edge(0) | edge(1) | edge(2);
    }

  private:
    void find_blocks(Square& square) const;
};

Cover::Cover(const Edges& edges, int i) {
    for (int k = 0; k < 3; ++k) {
        const std::int32_t column = edges.to_column[k][i], row = edges.to_row[k][i];
        const Ints of_pixels = load(lane_column) * column + load(lane_row) * row;
        store(of_pixel[k], of_pixels);
        store(of_block[k], of_pixels * 4);
        inwards[k] = 3 * (max(column, 0) + max(row, 0));
        outwards[k] = 3 * (min(column, 0) + min(row, 0));
        f[k] = edges.f[k][i];
        to_column[k] = column;
        to_row[k] = row;
    }
}

/// E is affine, so of a cell, as of a block, the corners decide that lie farthest in and out. Fifteen steps
/// are five times three.
Cells Cover::cells() const {
    Cells cells;
    Ints greatest = splat(0), least = splat(0);
    for (int k = 0; k < 3; ++k) {
        const Doubles of_cell = load(cell_x) * to_column[k] + load(cell_y) * to_row[k];
        const Ints first = clamped(splat(f[k]) + of_cell, most_of_f);
        store(cells.f[k], first);
        greatest = greatest | (first + splat(5 * inwards[k]));
        least = least | (first + splat(5 * outwards[k]));
    }
    cells.met = 0xFFFF & ~negative_lanes(greatest);
    cells.whole = 0xFFFF & ~negative_lanes(least);
    return cells;
}

void Cover::find_blocks(Square& square) const {
    Ints greatest = splat(0);
    for (int k = 0; k < 3; ++k) {
        const Ints of_blocks = load(of_block[k]) + splat(square.f[k]);
        store(square.of_block[k], of_blocks);
        greatest = greatest | (of_blocks + splat(inwards[k]));
    }
    square.met = 0xFFFF & ~negative_lanes(greatest);
    square.is_whole = false;
}

void Cover::set_to_cell(Square& square, const Cells& cells, int cell) const {
    square.x = cell % 4 * square_side;
    square.y = cell / 4 * square_side;
    for (int k = 0; k < 3; ++k) square.f[k] = cells.f[k][cell];
    square.met = 0xFFFF;
    square.is_whole = (cells.whole >> cell & 1) != 0;
    if (!square.is_whole) find_blocks(square);
}

void Cover::set_to_pixels_from(Square& square, int x, int y) const {
    square.x = x;
    square.y = y;
    for (int k = 0; k < 3; ++k) {
        const double exact = (f[k] + to_column[k] * x) + to_row[k] * y;
        square.f[k] = std::int32_t(max(min(exact, most_of_f), -most_of_f));
    }
    find_blocks(square);
}
