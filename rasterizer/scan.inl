// One triangle in one tile: squares of 4 x 4 blocks, then blocks of 4 x 4 pixels.

struct Block {
    int x, y;   ///< its first pixel in the tile
    int place;  ///< among the tile's blocks
    std::uint32_t id;
};

/// All of a block is covered.
struct Whole {
    unsigned covered() const { return 0xFFFF; }
    Mask of(const Mask& pixels) const { return pixels; }
};

/// Some of it, perhaps none.
struct Partly {
    Ints inside;  ///< negative where a pixel is not covered

    unsigned covered() const { return 0xFFFF & ~negative_lanes(inside); }
    Mask of(const Mask& pixels) const { return without_negative(pixels, inside); }
};

/// Bit i: pixel i of a block.
struct Won {
    unsigned covered, nearer;
};

/// Where something no nearer than `nearest` may win a pixel.
template <Ties ties>
Mask may_win(float nearest, const Floats& farthest) {
    return ties == Ties::least_id ? not_less(all(nearest), farthest) : greater(all(nearest), farthest);
}

/// Depth test, depth and id of the pixels of a block.
template <Ties ties, class Covered>
Won draw_block(TilePixels& pixels, const Block& block, const Floats& seen, const Covered& covered) {
    const std::ptrdiff_t first = std::ptrdiff_t{16} * block.place;
    const Floats before = load(pixels.nearness + first);
    Mask wins = covered.of(greater(seen, before));
    if (ties == Ties::least_id) {
        const Mask tied = covered.of(equal(seen, before));
        if (bits_of(tied) != 0) wins = wins | above(tied, pixels.primitive + first, block.id);
    }
    store(pixels.nearness + first, chosen(wins, seen, before));
    put(pixels.primitive + first, wins, block.id);
    return {covered.covered(), bits_of(wins)};
}

/// In the rows of a square from the first to the last that has any of the blocks, bit by bit.
void note_farthest(TilePixels& pixels, int place, unsigned blocks) {
    const int first = __builtin_ctz(blocks) / 4, last = (31 - __builtin_clz(blocks)) / 4;
    for (int row = first; row <= last; ++row) {
        const int at = place + blocks_in_row * row;
        store_least_of_four(pixels.farthest + at, pixels.nearness + std::ptrdiff_t{16} * at);
    }
}

constexpr int block_at(int x, int y) { return y / 4 * blocks_in_row + x / 4; }

/// Bit by bit.
void note_farthest_in_cells(TilePixels& pixels, unsigned cells) {
    for (; cells != 0; cells &= cells - 1) {
        const int cell = __builtin_ctz(cells);
        const float* const farthest = pixels.farthest + block_at(cell % 4 * 16, cell / 4 * 16);
        pixels.farthest_in_cell[cell] = least_of(load_square(farthest, blocks_in_row));
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
            cells &= bits_of(may_win<Visit::ties>(edges.nearest[i], load(work.pixels.farthest_in_cell)));
        if (cells == 0) return;
        const Cover cover(edges, i);
        const NearnessPlane nearness(batch, edges, work.samples, i);
        const unsigned drawn =
            is_in_a_square() ? draw_square(cover, nearness, cells) : draw_cells(cover, nearness, cells);
        note_farthest_in_cells(work.pixels, drawn);
    }

  private:
    /// The first pixel of the square that begins with the box, or ends with the tile.
    int first_x() const { return lesser(batch.column0[i] & ~3, tile_size - square_side); }
    int first_y() const { return lesser(batch.row0[i] & ~3, tile_size - square_side); }
    bool is_in_a_square() const {
        return batch.column1[i] < first_x() + square_side && batch.row1[i] < first_y() + square_side;
    }

    // Of `cells`, bit by bit, those drawn into.

    unsigned draw_square(const Cover& cover, const NearnessPlane& nearness, unsigned cells) const {
        const int x = first_x(), y = first_y();
        Square square;
        cover.set_to_pixels_from(square, x, y);
        square.met &= bits_of_box((batch.column0[i] - x) / 4, (batch.column1[i] - x) / 4,
                                  (batch.row0[i] - y) / 4, (batch.row1[i] - y) / 4);
        return draw_if_open(square, cover, nearness) ? cells : 0;
    }

    unsigned draw_cells(const Cover& cover, const NearnessPlane& nearness, unsigned cells) const {
        const Cells found = cover.cells();
        unsigned drawn = 0;
        for (unsigned left = cells & found.met; left != 0; left &= left - 1) {
            Square square;
            cover.set_to_cell(square, found, __builtin_ctz(left));
            if (draw_if_open(square, cover, nearness)) drawn |= left & -left;
        }
        return drawn;
    }

    /// Where a block holds something farther. Returns whether there is any.
    bool draw_if_open(Square& square, const Cover& cover, const NearnessPlane& nearness) const {
        const Floats farthest =
            load_square(work.pixels.farthest + block_at(square.x, square.y), blocks_in_row);
        const unsigned open = square.met & bits_of(may_win<Visit::ties>(edges.nearest[i], farthest));
        visit.leave_out(square.met & ~open);
        square.met = open;
        if (open != 0) draw(square, cover, nearness);
        return open != 0;
    }

    void draw(const Square& square, const Cover& cover, const NearnessPlane& nearness) const {
        if (square.is_whole)
            draw_blocks(square, nearness, [](int) { return Whole{}; });
        else
            draw_blocks(square, nearness, [&](int block) { return Partly{cover.inside(square, block)}; });
        visit.drawn(work.pixels, block_at(square.x, square.y), square.met);
    }

    template <class CoveredOf>
    void draw_blocks(const Square& square, const NearnessPlane& nearness, const CoveredOf& covered_of) const {
        const NearnessPlane::At at = nearness.at(square.x, square.y);
        for (unsigned left = square.met; left != 0; left &= left - 1) {
            const int b = __builtin_ctz(left), x = square.x + b % 4 * 4, y = square.y + b / 4 * 4;
            const Block block{x, y, block_at(x, y), batch.id[i]};
            visit.block(work.pixels, block, nearness.of_pixels(at, b), covered_of(b));
        }
    }
};

template <class Visit>
void scan_triangle(const TileWork& work, const Batch& batch, const Edges& edges, int i, const Visit& visit) {
    TriangleScan<Visit>{work, batch, edges, i, visit}.scan();
}
