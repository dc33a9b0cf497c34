// What the scan of larger triangles needs beside their weights, for a batch at once.
//
// From one pixel to the next E takes steps of 2^bits, so E >= least exactly where F >= 0, with
// F = floor((E - least) / 2^bits): whole numbers, whose steps are the differences of two vertices.

/// The bits, of 4 x 4, in the columns and rows from first to last.
constexpr unsigned bits_of_box(int column0, int column1, int row0, int row1) {
    const unsigned columns = (2u << column1) - (1u << column0);
    return (columns * 0x1111) & ((0x10u << 4 * row1) - (1u << 4 * row0));
}

struct Edges {
    alignas(64) double e[3][batch_size], f[3][batch_size];  ///< E, F at the sample of the tile's first pixel
    /// Step of F to the next column, row; of E it is 2^bits times that.
    alignas(64) std::int32_t to_column[3][batch_size], to_row[3][batch_size];
    alignas(64) float nearest[batch_size];        ///< no pixel gets more
    alignas(64) std::uint32_t cells[batch_size];  ///< of the tile, bit by bit: those that the box meets

    void set_up(const Batch& batch, const TileSamples& tile);

  private:
    void set_up_edge(int k, const Batch& batch, const TileSamples& tile);
    void set_up_nearest(const Batch& batch);
    void set_up_cells(const Batch& batch);
};

/// Needs |a| <= 2^51: the sum is in [2^52, 2^53], where doubles are the whole numbers.
constexpr double floor_of(double a) {
    constexpr double no_fractions = 0x1.8p52;
    const double nearest = (a + no_fractions) - no_fractions;
    return nearest > a ? nearest - 1 : nearest;
}

/// E(p) = dx (p.y - from.y) - dy (p.x - from.x). 0.0 turns a -0 into the 0 that integers know.
void Edges::set_up_edge(int k, const Batch& batch, const TileSamples& tile) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const std::int32_t steps = std::int32_t{1} << tile.subpixel_bits;
    const std::int32_t sample_x = tile.x0 * steps + tile.sample_offset;
    const std::int32_t sample_y = tile.y0 * steps + tile.sample_offset;
    const double of_top_left = tile.least_of_top_left, of_others = tile.least_of_others;
    const double of_a_step = 1.0 / steps;
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t dx = batch.x[to][i] - batch.x[from][i], dy = batch.y[to][i] - batch.y[from][i];
        const double at_first = (double(dx) * double(sample_y - batch.y[from][i]) -
                                 double(dy) * double(sample_x - batch.x[from][i])) +
                                0.0;
        const double least = is_top_left(dx, dy) ? of_top_left : of_others;
        e[k][i] = at_first;
        f[k][i] = floor_of((at_first - least) * of_a_step);
        to_column[k][i] = -dy;
        to_row[k][i] = dx;
    }
}

void Edges::set_up_nearest(const Batch& batch) {
    for (int i = 0; i < batch_size; ++i)
        nearest[i] =
            nearest_pixel(batch.inverse_depth[0][i], batch.inverse_depth[1][i], batch.inverse_depth[2][i]);
}

/// The cells of an empty box may be any.
void Edges::set_up_cells(const Batch& batch) {
    const auto cell = [](std::int32_t pixel) { return pixel / 16 & 3; };
    for (int i = 0; i < batch_size; ++i)
        cells[i] = bits_of_box(cell(batch.column0[i]), cell(batch.column1[i]), cell(batch.row0[i]),
                               cell(batch.row1[i]));
}

void Edges::set_up(const Batch& batch, const TileSamples& tile) {
    for (int k = 0; k < 3; ++k) set_up_edge(k, batch, tile);
    set_up_nearest(batch);
    set_up_cells(batch);
}
