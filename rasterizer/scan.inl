// One triangle in one tile, block by block of 4 x 4 pixels, and cell by cell of 4 x 4 blocks.

alignas(64) constexpr double lane_column[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr double lane_row[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// Lane i is column i % 4, row i / 4, of a block of pixels or of a cell of blocks.
struct Scan {
    Doubles offset[3];  ///< of E, from lane 0
    double e[3], a[3], b[3], least[3], weight[3];
    float nearest;
    std::uint32_t id;

    Scan(const Batch& batch, const Edges& edges, int i) : nearest(edges.nearest[i]), id(batch.id[i]) {
        for (int k = 0; k < 3; ++k) {
            e[k] = edges.e[k][i];
            a[k] = edges.a[k][i];
            b[k] = edges.b[k][i];
            least[k] = edges.least[k][i];
            weight[k] = batch.weight[k][i];
            offset[k] = load(lane_column) * a[k] + load(lane_row) * b[k];
        }
    }
    /// E of edge k at pixel (x, y) of the tile.
    double at(int k, int x, int y) const { return (e[k] + a[k] * x) + b[k] * y; }
};

/// A block of 4 x 4 pixels: where it is kept, its first pixel in the tile, and E there.
struct Block {
    int place, x, y;
    double e[3];
};

constexpr int cell_at(int x, int y) { return y / 16 * 4 + x / 16; }

Block block_at(const Scan& scan, int x, int y) {
    return {cell_at(x, y) * 16 + y / 4 % 4 * 4 + x / 4 % 4,
            x,
            y,
            {scan.at(0, x, y), scan.at(1, x, y), scan.at(2, x, y)}};
}

/// Bit i: pixel i of a block.
struct Won {
    unsigned covered, nearer;
    Floats held;  ///< nearness of the block's pixels now, where any is covered
};

auto covered_by(const Scan& scan, const Doubles (&e)[3]) {
    return at_least(e[0], scan.least[0]) & at_least(e[1], scan.least[1]) & at_least(e[2], scan.least[2]);
}

/// Depth test, depth and id of the pixels of a block.
Won draw_block(const Scan& scan, TilePixels& pixels, const Block& block) {
    const Doubles e[3] = {all(block.e[0]) + scan.offset[0], all(block.e[1]) + scan.offset[1],
                          all(block.e[2]) + scan.offset[2]};
    const auto inside = covered_by(scan, e);
    const unsigned covered = bits_of(inside);
    Floats held = load(pixels.nearness + 16 * block.place);
    if (covered == 0) return {0, 0, held};
    const Floats seen = rounded((e[0] * scan.weight[0] + e[1] * scan.weight[1]) + e[2] * scan.weight[2]);
    const auto wins = narrowed(inside) & greater(seen, held);
    held = chosen(wins, seen, held);
    store(pixels.nearness + 16 * block.place, held);
    put(pixels.primitive + 16 * block.place, wins, scan.id);
    return {covered, bits_of(wins), held};
}

bool is_hidden(const Scan& scan, const TilePixels& pixels, int place) {
    return !(scan.nearest > pixels.farthest[place]);
}

void note_farthest(TilePixels& pixels, int place, const Floats& held) {
    pixels.farthest[place] = least_of(held);
}

/// Bit by bit.
void note_farthest_in_cells(TilePixels& pixels, unsigned cells) {
    for (; cells != 0; cells &= cells - 1) {
        const int cell = __builtin_ctz(cells);
        pixels.farthest_in_cell[cell] = least_of(load(pixels.farthest + 16 * cell));
    }
}

/// Of the 16 blocks of a cell, bit by bit.
struct Blocks {
    unsigned met;                 ///< may have covered pixels
    unsigned open;                ///< of those, may have pixels that can win
    alignas(64) double e[3][16];  ///< E at the blocks' first pixels
};

/// Of the 16 blocks from pixel (x, y): E is affine, so of each block the corner decides that lies farthest
/// inwards.
void find_blocks(Blocks& blocks, const Scan& scan, const TilePixels& pixels, int x, int y) {
    const auto reached = [&](int k) {
        const double to_corner = 3 * (greater_of(scan.a[k], 0.0) + greater_of(scan.b[k], 0.0));
        const Doubles e = all(scan.at(k, x, y)) + scan.offset[k] * 4.0;
        store(blocks.e[k], e);
        return at_least(e + all(to_corner), scan.least[k]);
    };
    blocks.met = bits_of(reached(0) & reached(1) & reached(2));
    const float* const farthest = pixels.farthest + 16 * cell_at(x, y);
    blocks.open = blocks.met & bits_of(greater(all(scan.nearest), load(farthest)));
}

/// Cells in which nothing of a triangle can be seen.
enum class HiddenCells { passed_over, visited };

template <class Visit>
void scan_cell(const Scan& scan, TilePixels& pixels, int cell, const Visit& visit) {
    const int x = cell % 4 * 16, y = cell / 4 * 16;
    Blocks blocks;
    find_blocks(blocks, scan, pixels, x, y);
    visit.leave_out(blocks.met & ~blocks.open);
    for (unsigned left = blocks.open; left != 0; left &= left - 1) {
        const int i = __builtin_ctz(left);
        visit.block(
            scan, pixels,
            {cell * 16 + i, x + i % 4 * 4, y + i / 4 * 4, {blocks.e[0][i], blocks.e[1][i], blocks.e[2][i]}});
    }
    if (blocks.open != 0) note_farthest_in_cells(pixels, 1u << cell);
}

/// Of the tile's cells, bit by bit: those that the box meets.
unsigned cells_of_box(const Batch& batch, int i) {
    const int column0 = batch.column0[i] / 16, column1 = batch.column1[i] / 16;
    const int row0 = batch.row0[i] / 16, row1 = batch.row1[i] / 16;
    const unsigned columns = (2u << column1) - (1u << column0);
    return (columns * 0x1111) & ((0x10u << 4 * row1) - (1u << 4 * row0));
}

template <class Visit>
void scan_triangle(TilePixels& pixels, const Batch& batch, const Edges& edges, int i, const Visit& visit) {
    unsigned cells = cells_of_box(batch, i);
    if (Visit::hidden_cells == HiddenCells::passed_over)
        cells &= bits_of(greater(all(edges.nearest[i]), load(pixels.farthest_in_cell)));
    if (cells == 0) return;
    const Scan scan(batch, edges, i);
    const int x0 = batch.column0[i] & ~3, x1 = batch.column1[i] & ~3;
    const int y0 = batch.row0[i] & ~3, y1 = batch.row1[i] & ~3;
    if (x1 - x0 <= 4 && y1 - y0 <= 4) {
        for (int y = y0; y <= y1; y += 4)
            for (int x = x0; x <= x1; x += 4) visit.lone_block(scan, pixels, block_at(scan, x, y));
        return note_farthest_in_cells(pixels, cells);
    }
    for (; cells != 0; cells &= cells - 1) scan_cell(scan, pixels, __builtin_ctz(cells), visit);
}
