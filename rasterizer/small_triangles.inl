// Triangles of a few pixels: all of a batch at one pixel of their boxes, then at the next, in 32-bit
// integers.

/// place_in_tile (tile_pixels.h), as a sum.
struct Places {
    int of_column[tile_size] = {}, of_row[tile_size] = {};
};

constexpr Places places_in_tile() {
    Places places;
    for (int i = 0; i < tile_size; ++i) {
        places.of_column[i] = place_in_tile(i, 0);
        places.of_row[i] = place_in_tile(0, i);
    }
    return places;
}

constexpr Places places = places_in_tile();

/// Edges of small triangles. Of E less what the edge needs to cover: E >= least where that is >= 0.
struct SmallEdges {
    alignas(64) std::int32_t e[batch_size];                 ///< at the first sample of the box
    alignas(64) std::int32_t a[batch_size], b[batch_size];  ///< step to the next column, row
    alignas(64) std::int32_t least[batch_size];
};

/// The small ones of a batch. A lane that is none, or empty, covers nothing.
struct SmallTriangles {
    alignas(64) std::int32_t covered[batch_size];                 ///< bit 4 row + column of the box
    alignas(64) float seen[small_side * small_side][batch_size];  ///< nearness there; means nothing elsewhere

    void cover(const Batch& batch, const TileSamples& tile);

  private:
    SmallEdges edges_[3];  ///< [k] is opposite vertex k

    SmallEdges edges_opposite(int k, const Batch& batch, const TileSamples& tile) const;
    void cover_pixel(const Batch& batch, int column, int row);
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

/// The same operations as in NearnessPlane (nearness.inl), on the same whole numbers.
void SmallTriangles::cover_pixel(const Batch& batch, int column, int row) {
    const int pixel = small_side * row + column;
    const auto& [edge0, edge1, edge2] = edges_;
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t e0 = edge0.e[i] + column * edge0.a[i] + row * edge0.b[i];
        const std::int32_t e1 = edge1.e[i] + column * edge1.a[i] + row * edge1.b[i];
        const std::int32_t e2 = edge2.e[i] + column * edge2.a[i] + row * edge2.b[i];
        covered[i] |= (~(e0 | e1 | e2) >> 31) & (1 << pixel);
        seen[pixel][i] = float((double(e0 + edge0.least[i]) * batch.weight[0][i] +
                                double(e1 + edge1.least[i]) * batch.weight[1][i]) +
                               double(e2 + edge2.least[i]) * batch.weight[2][i]);
    }
}

void SmallTriangles::cover(const Batch& batch, const TileSamples& tile) {
    for (int k = 0; k < 3; ++k) edges_[k] = edges_opposite(k, batch, tile);
    std::int32_t columns = 0, rows = 0;
    alignas(64) std::int32_t box[batch_size];
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t last_column = (batch.column1[i] - batch.column0[i]) & batch.is_small[i];
        const std::int32_t last_row = (batch.row1[i] - batch.row0[i]) & batch.is_small[i];
        columns = greater_of(columns, last_column);
        rows = greater_of(rows, last_row);
        const std::int32_t in_rows = 0xFFFF >> (12 - 4 * (last_row & 3));
        const std::int32_t in_columns = (0xF >> (3 - (last_column & 3))) * 0x1111;
        const std::int32_t is_met = ((last_column >= 0) & (last_row >= 0)) ? ~0 : 0;
        box[i] = is_met & batch.is_small[i] & in_rows & in_columns;
        covered[i] = 0;
    }
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) cover_pixel(batch, column, row);
    for (int i = 0; i < batch_size; ++i) covered[i] &= box[i];
}
