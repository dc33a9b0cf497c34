// Sixteen triangles side by side, set up together. Loops over the lanes are plain: the compiler makes vectors
// of them.

constexpr int small_side = 4;  ///< pixels of a small triangle's box, at most

/// The longest side of a small triangle's box, grid steps. Differences of its vertices, and from its first
/// sample, are <= 2^13 (the box is cut to samples between the vertices), E there <= 2^27; three steps
/// to the right and three down, at most 2^12 grid steps to a pixel, add 6 * 2^25. So every |E| is < 2^29.
constexpr std::int32_t small_extent = 1 << 13;

/// [k] is a vertex, or the edge opposite to it.
struct Batch {
    alignas(64) std::int32_t x[3][batch_size], y[3][batch_size];
    alignas(64) double inverse_depth[3][batch_size];
    alignas(64) std::uint32_t id[batch_size];

    /// The first and the last pixel of the box in the tile. The box is empty where the last is before the
    /// first.
    alignas(64) std::int32_t column0[batch_size], column1[batch_size], row0[batch_size], row1[batch_size];
    alignas(64) std::int32_t is_small[batch_size];  ///< all ones, or 0: see small_side
    alignas(64) double weight[3][batch_size];       ///< inverse depth of vertex k, divided by 2A

    /// The batch is filled up with the last triangle.
    void load(const Triangles& triangles, const std::uint32_t* entries, int last);
    void set_up_box(const TileSamples& tile);
    void set_up_weights();

  private:
    void put_corner(int k, const SnappedVertex* const (&corner)[batch_size]) {
        put_side_by_side(corner, x[k], y[k], inverse_depth[k]);
    }
};

void Batch::load(const Triangles& triangles, const std::uint32_t* entries, int last) {
    const SnappedVertex* corner[3][batch_size];
    for (int i = 0; i < batch_size; ++i) {
        const std::uint32_t entry = entries[min(i, last)], place = entry & ~turned;
        const SnappedVertex *a, *b, *c;
        if (place < triangles.length) {
            const glm::uvec3& index = triangles.corners[place];
            a = triangles.vertices + index.x;
            b = triangles.vertices + index.y;
            c = triangles.vertices + index.z;
            id[i] = place;
        } else {
            const SnappedPiece& piece = triangles.pieces[place - triangles.length];
            a = piece.vertex, b = piece.vertex + 1, c = piece.vertex + 2;
            id[i] = static_cast<std::uint32_t>(piece.id);
        }
        const bool is_turned = (entry & turned) != 0;
        corner[0][i] = a;
        corner[1][i] = is_turned ? c : b;
        corner[2][i] = is_turned ? b : c;
    }
    for (int k = 0; k < 3; ++k) put_corner(k, corner[k]);
}

/// Pixels whose samples lie in the bounding box, cut to the tile; shifts floor.
void Batch::set_up_box(const TileSamples& tile) {
    const std::int32_t offset = tile.sample_offset, bits = tile.subpixel_bits;
    const std::int32_t before_next = (std::int32_t{1} << bits) - 1;
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t left = min(min(x[0][i], x[1][i]), x[2][i]);
        const std::int32_t right = max(max(x[0][i], x[1][i]), x[2][i]);
        const std::int32_t top = min(min(y[0][i], y[1][i]), y[2][i]);
        const std::int32_t bottom = max(max(y[0][i], y[1][i]), y[2][i]);
        column0[i] = max(((left - offset + before_next) >> bits) - tile.x0, 0);
        column1[i] = min(((right - offset) >> bits) - tile.x0, tile_size - 1);
        row0[i] = max(((top - offset + before_next) >> bits) - tile.y0, 0);
        row1[i] = min(((bottom - offset) >> bits) - tile.y0, tile_size - 1);
        const std::int32_t columns = column1[i] - column0[i] + 1, rows = row1[i] - row0[i] + 1;
        const std::int32_t extent = max(right - left, bottom - top);
        const bool fits = (columns <= small_side) & (rows <= small_side) & (extent <= small_extent);
        is_small[i] = fits ? ~0 : 0;
    }
}

void Batch::set_up_weights() {
    for (int i = 0; i < batch_size; ++i) {
        const double doubled_area = double(x[2][i] - x[1][i]) * double(y[0][i] - y[1][i]) -
                                    double(y[2][i] - y[1][i]) * double(x[0][i] - x[1][i]);
        weight[0][i] = inverse_depth[0][i] / doubled_area;
        weight[1][i] = inverse_depth[1][i] / doubled_area;
        weight[2][i] = inverse_depth[2][i] / doubled_area;
    }
}
