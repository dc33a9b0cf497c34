// What the scan of larger triangles needs beside their weights, for a batch at once.

struct Edges {
    alignas(64) double e[3][batch_size];                    ///< E at the sample of the tile's first pixel
    alignas(64) double a[3][batch_size], b[3][batch_size];  ///< step of E to the next column, row
    alignas(64) double least[3][batch_size];                ///< the least E that is covered
    alignas(64) float nearest[batch_size];                  ///< no pixel gets more

    void set_up(const Batch& batch, const TileSamples& tile);

  private:
    void set_up_edge(int k, const Batch& batch, const TileSamples& tile);
    void set_up_nearest(const Batch& batch);
};

/// E(p) = dx (p.y - from.y) - dy (p.x - from.x). 0.0 turns a -0 into the 0 that integers know.
void Edges::set_up_edge(int k, const Batch& batch, const TileSamples& tile) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const std::int32_t steps = std::int32_t{1} << tile.subpixel_bits;
    const std::int32_t sample_x = tile.x0 * steps + tile.sample_offset;
    const std::int32_t sample_y = tile.y0 * steps + tile.sample_offset;
    const double of_top_left = tile.least_of_top_left, of_others = tile.least_of_others;
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t dx = batch.x[to][i] - batch.x[from][i], dy = batch.y[to][i] - batch.y[from][i];
        e[k][i] = (double(dx) * double(sample_y - batch.y[from][i]) -
                   double(dy) * double(sample_x - batch.x[from][i])) +
                  0.0;
        a[k][i] = -double(dy) * double(steps);
        b[k][i] = double(dx) * double(steps);
        least[k][i] = is_top_left(dx, dy) ? of_top_left : of_others;
    }
}

/// A covered pixel gets at most max N + 4u max |N| (u = 2^-53, of three roundings per term and the
/// quotient's; what underflow adds is lost in the rounding to float32). 2^-50 is twice that, for this sum's
/// own rounding. Rounding to float32 keeps the order.
void Edges::set_up_nearest(const Batch& batch) {
    for (int i = 0; i < batch_size; ++i) {
        const double n0 = batch.nearness[0][i], n1 = batch.nearness[1][i], n2 = batch.nearness[2][i];
        const double most = greater_of(n0, greater_of(n1, n2));
        const double largest = greater_of(magnitude(n0), greater_of(magnitude(n1), magnitude(n2)));
        nearest[i] = float(most + 0x1p-50 * largest);
    }
}

void Edges::set_up(const Batch& batch, const TileSamples& tile) {
    for (int k = 0; k < 3; ++k) set_up_edge(k, batch, tile);
    set_up_nearest(batch);
}
