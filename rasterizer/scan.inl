// One triangle in one tile: squares of 4 x 4 blocks, then blocks of 4 x 4 pixels.

struct Block {
    int x, y;   ///< its first pixel in the tile
    int place;  ///< among the tile's blocks
    std::uint32_t id;
};

/// All of a block is covered.
struct FullCoverage {
    unsigned covered() const { return 0xFFFF; }
    Mask of(const Mask& pixels) const { return pixels; }
};

/// Some of a block is covered, or none.
struct PartialCoverage {
    Ints inside;  ///< negative where a pixel is not covered

    unsigned covered() const { return 0xFFFF & ~negative_lanes(inside); }
    Mask of(const Mask& pixels) const { return without_negative(pixels, inside); }
};

/// Bit i stands for pixel i of a block.
struct PassedPixels {
    unsigned covered, nearer;
};

/// The blocks where something no nearer than `nearest` may win a pixel.
template <Ties ties>
Mask may_win(float nearest, const Floats& hiz) {
    return ties == Ties::least_id ? not_less(splat(nearest), hiz) : greater(splat(nearest), hiz);
}

/// Depth test, depth and id of the pixels of a block.
template <Ties ties, class Covered>
PassedPixels draw_block(TilePixels& pixels, const Block& block, const Floats& seen, const Covered& covered) {
    const std::ptrdiff_t first = std::ptrdiff_t{16} * block.place;
    const Floats before = load(pixels.inverse_depth + first);
    Mask wins = covered.of(greater(seen, before));
    if (ties == Ties::least_id) {
        const Mask tied = covered.of(equal(seen, before));
        if (bits_of(tied) != 0) wins = wins | above(tied, pixels.primitive + first, block.id);
    }
    store(pixels.inverse_depth + first, select(wins, seen, before));
    put(pixels.primitive + first, wins, block.id);
    return {covered.covered(), bits_of(wins)};
}

/// Updates the rows of a square from the first to the last that has any of the blocks, bit by bit.
void update_hiz(TilePixels& pixels, int place, unsigned blocks) {
    const int first = __builtin_ctz(blocks) / 4, last = (31 - __builtin_clz(blocks)) / 4;
    for (int row = first; row <= last; ++row) {
        const int at = place + blocks_in_row * row;
        store_least_of_four(pixels.hiz + at, pixels.inverse_depth + std::ptrdiff_t{16} * at);
    }
}

constexpr int block_at(int x, int y) { return y / 4 * blocks_in_row + x / 4; }

/// Updates the cells given bit by bit.
void update_hiz_of_cells(TilePixels& pixels, unsigned cells) {
    for (; cells != 0; cells &= cells - 1) {
        const int cell = __builtin_ctz(cells);
        const float* const hiz = pixels.hiz + block_at(cell % 4 * 16, cell / 4 * 16);
        pixels.hiz_of_cell[cell] = least_of(load_square(hiz, blocks_in_row));
    }
}

/// Cells in which nothing of a triangle can be seen.
enum class HiddenCells { passed_over, visited };

/// A triangle in a tile, and what is to be done where it may be seen.
template <class Visit>
struct TriangleScan {
    const TileWork& work;
    const Batch& batch;
    const Edges& edges;
    const int i;
    const Visit& visit;

    void scan() const {
        unsigned cells = edges.cells[i];
        if (Visit::hidden_cells == HiddenCells::passed_over)
            cells &= bits_of(may_win<Visit::ties>(edges.nearest[i], load(work.pixels.hiz_of_cell)));
        if (cells == 0) return;
        const Cover cover(edges, i);
        const InverseDepthPlane inverse_depth(batch, edges, work.samples, i);
        const unsigned drawn = is_in_a_square() ? draw_square(cover, inverse_depth, cells)
                                                : draw_cells(cover, inverse_depth, cells);
        update_hiz_of_cells(work.pixels, drawn);
    }

  private:
    /// The first pixel of the square that begins with the box, or ends with the tile.
    int first_x() const { return min(batch.column0[i] & ~3, tile_size - square_side); }
    int first_y() const { return min(batch.row0[i] & ~3, tile_size - square_side); }
    bool is_in_a_square() const {
        return batch.column1[i] < first_x() + square_side && batch.row1[i] < first_y() + square_side;
    }

    // These return which of `cells` they drew into, bit by bit.

    unsigned draw_square(const Cover& cover, const InverseDepthPlane& inverse_depth, unsigned cells) const {
        const int x = first_x(), y = first_y();
        Square square;
        cover.set_to_pixels_from(square, x, y);
        square.met &= bits_of_box((batch.column0[i] - x) / 4, (batch.column1[i] - x) / 4,
                                  (batch.row0[i] - y) / 4, (batch.row1[i] - y) / 4);
        return draw_if_open(square, cover, inverse_depth) ? cells : 0;
    }

    unsigned draw_cells(const Cover& cover, const InverseDepthPlane& inverse_depth, unsigned cells) const {
        const Cells found = cover.cells();
        unsigned drawn = 0;
        for (unsigned left = cells & found.met; left != 0; left &= left - 1) {
            Square square;
            cover.set_to_cell(square, found, __builtin_ctz(left));
            if (draw_if_open(square, cover, inverse_depth)) drawn |= left & -left;
        }
        return drawn;
    }

    /// Draws the blocks that hold something farther. Returns whether there is any.
    bool draw_if_open(Square& square, const Cover& cover, const InverseDepthPlane& inverse_depth) const {
        const Floats hiz = load_square(work.pixels.hiz + block_at(square.x, square.y), blocks_in_row);
        const unsigned open = square.met & bits_of(may_win<Visit::ties>(edges.nearest[i], hiz));
        visit.leave_out(square.met & ~open);
        square.met = open;
        if (open != 0) draw(square, cover, inverse_depth);
        return open != 0;
    }

    void draw(const Square& square, const Cover& cover, const InverseDepthPlane& inverse_depth) const {
        if (square.is_whole)
            draw_blocks(square, inverse_depth, [](int) { return FullCoverage{}; });
        else
            draw_blocks(square, inverse_depth,
                        [&](int block) { return PartialCoverage{cover.inside(square, block)}; });
        visit.drawn(work.pixels, block_at(square.x, square.y), square.met);
    }

    template <class CoveredOf>
    void draw_blocks(const Square& square, const InverseDepthPlane& inverse_depth,
                     const CoveredOf& covered_of) const {
        const InverseDepthPlane::At at = inverse_depth.at(square.x, square.y);
        for (unsigned left = square.met; left != 0; left &= left - 1) {
            const int b = __builtin_ctz(left), x = square.x + b % 4 * 4, y = square.y + b / 4 * 4;
            const Block block{x, y, block_at(x, y), batch.id[i]};
            visit.block(work.pixels, block, inverse_depth.of_pixels(at, b), covered_of(b));
        }
    }
};

template <class Visit>
void scan_triangle(const TileWork& work, const Batch& batch, const Edges& edges, int i, const Visit& visit) {
    TriangleScan<Visit>{work, batch, edges, i, visit}.scan();
}
