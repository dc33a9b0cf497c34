// Triangles of a few pixels: all of a batch at one pixel of their boxes, then at the next, in 32-bit
// integers.

/// Edges of small triangles. Of E less what the edge needs to cover: E >= least where that is >= 0.
struct SmallEdges {
    alignas(64) std::int32_t e[batch_size];                 ///< at the first sample of the box
    alignas(64) std::int32_t a[batch_size], b[batch_size];  ///< step to the next column, row
    alignas(64) std::int32_t least[batch_size];
};

/// The small ones of a batch. A lane that is none, or empty, covers nothing. Pixel (column, row) of a box is
/// its pixel 4 row + column, and index 16 pixel + i that of the i-th triangle.
struct SmallTriangles {
    static constexpr int pixels = small_side * small_side;

    alignas(64) float seen[pixels][batch_size];          ///< inverse depth; means nothing where not covered
    alignas(64) std::int32_t place[pixels][batch_size];  ///< in the tile (place_in_tile); likewise
    std::uint8_t
        fragment[pixels * batch_size + 16];  ///< indices of what is covered, one triangle's after another's
    std::int32_t first[batch_size + 1];      ///< where each triangle's begin, and their end

    void cover(const Batch& batch, const TileSamples& tile);

  private:
    alignas(64) std::int32_t covered_[batch_size];  ///< pixels of the box, bit by bit
    alignas(64) std::int32_t of_column_[small_side][batch_size],
        of_row_[small_side][batch_size];  ///< of `place`
    SmallEdges edges_[3];                 ///< [k] is opposite vertex k

    SmallEdges edges_opposite(int k, const Batch& batch, const TileSamples& tile) const;
    void find_places(const Batch& batch);
    void cover_pixels(const Batch& batch, int columns, int rows);
    void list_fragments();
};

/// E(p) = dx (p.y - from.y) - dy (p.x - from.x).
SmallEdges SmallTriangles::edges_opposite(int k, const Batch& batch, const TileSamples& tile) const {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const std::int32_t bits = tile.subpixel_bits;
    const std::int32_t tile_x = tile.x0, tile_y = tile.y0, offset = tile.sample_offset;
    const std::int32_t of_top_left = tile.least_of_top_left, of_others = tile.least_of_others;
    SmallEdges edge;
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t sample_x = ((tile_x + batch.column0[i]) << bits) + offset;
        const std::int32_t sample_y = ((tile_y + batch.row0[i]) << bits) + offset;
        const std::int32_t from_x = (sample_x - batch.x[from][i]) & batch.is_small[i];
        const std::int32_t from_y = (sample_y - batch.y[from][i]) & batch.is_small[i];
        const std::int32_t dx = (batch.x[to][i] - batch.x[from][i]) & batch.is_small[i];
        const std::int32_t dy = (batch.y[to][i] - batch.y[from][i]) & batch.is_small[i];
        edge.least[i] = is_top_left(dx, dy) ? of_top_left : of_others;
        edge.e[i] = dx * from_y - dy * from_x - edge.least[i];
        edge.a[i] = -dy * (1 << bits);
        edge.b[i] = dx * (1 << bits);
    }
    return edge;
}

/// A step at a time, garbage where a box ends before.
void SmallTriangles::find_places(const Batch& batch) {
    for (int step = 0; step < small_side; ++step) {
        for (int i = 0; i < batch_size; ++i) {
            of_column_[step][i] = place_in_tile(batch.column0[i] + step, 0);
            of_row_[step][i] = place_in_tile(0, batch.row0[i] + step);
        }
    }
}

/// The first columns and rows of all boxes; the same operations as in InverseDepthPlane (inverse depth.inl),
/// on the same whole numbers.
void SmallTriangles::cover_pixels(const Batch& batch, int columns, int rows) {
    const Doubles weight[] = {load(batch.weight[0]), load(batch.weight[1]), load(batch.weight[2])};
    Ints covered = splat(0), of_row[] = {load(edges_[0].e), load(edges_[1].e), load(edges_[2].e)};
    for (int row = 0; row < rows; ++row) {
        Ints e[] = {of_row[0], of_row[1], of_row[2]};
        for (int column = 0; column < columns; ++column) {
            const int pixel = small_side * row + column;
            covered = with_bit_where_not_negative(covered, 1 << pixel, e[0] | e[1] | e[2]);
            const auto term = [&](int k) { return doubles_of(e[k] + load(edges_[k].least)) * weight[k]; };
            store(seen[pixel], rounded((term(0) + term(1)) + term(2)));
            store(place[pixel], load(of_column_[column]) + load(of_row_[row]));
            for (int k = 0; k < 3; ++k) e[k] = e[k] + load(edges_[k].a);
        }
        for (int k = 0; k < 3; ++k) of_row[k] = of_row[k] + load(edges_[k].b);
    }
    store(covered_, covered);
}

void SmallTriangles::list_fragments() {
    int count = 0;
    for (int i = 0; i < batch_size; ++i) {
        first[i] = count;
        count += put_bits(fragment + count, unsigned(covered_[i]), i);
    }
    first[batch_size] = count;
}

void SmallTriangles::cover(const Batch& batch, const TileSamples& tile) {
    for (int k = 0; k < 3; ++k) edges_[k] = edges_opposite(k, batch, tile);
    find_places(batch);
    std::int32_t columns = 0, rows = 0;
    alignas(64) std::int32_t box[batch_size];
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t last_column = (batch.column1[i] - batch.column0[i]) & batch.is_small[i];
        const std::int32_t last_row = (batch.row1[i] - batch.row0[i]) & batch.is_small[i];
        columns = max(columns, last_column);
        rows = max(rows, last_row);
        const std::int32_t in_rows = 0xFFFF >> (12 - 4 * (last_row & 3));
        const std::int32_t in_columns = (0xF >> (3 - (last_column & 3))) * 0x1111;
        const std::int32_t is_met = ((last_column >= 0) & (last_row >= 0)) ? ~0 : 0;
        box[i] = is_met & batch.is_small[i] & in_rows & in_columns;
    }
    cover_pixels(batch, columns + 1, rows + 1);
    for (int i = 0; i < batch_size; ++i) covered_[i] &= box[i];
    list_fragments();
}
