// Sixteen triangles side by side, set up together. Loops over the lanes are plain: the compiler makes vectors
// of them.

constexpr int batch_size = 16;

/// [k] is a vertex, or the edge opposite to it.
struct Batch {
    alignas(64) std::int32_t x[3][batch_size], y[3][batch_size];
    alignas(64) double nearness[3][batch_size];
    alignas(64) std::uint32_t id[batch_size];

    /// Of the box in the tile, pixels: first, last. Nothing is in it where the last is before the first.
    alignas(64) std::int32_t column0[batch_size], column1[batch_size], row0[batch_size], row1[batch_size];
    alignas(64) std::int32_t extent[batch_size];  ///< the longer side of the whole box, grid steps
    alignas(64) double weight[3][batch_size];     ///< nearness of vertex k, divided by 2A

    /// Filled up with the last triangle.
    void load(const Triangles& triangles, const std::uint32_t* places, int last);
    void set_up_box(const TileSamples& tile);
    void set_up_weights();

  private:
    void put_vertex(int k, int i, const SnappedVertex& v) {
        x[k][i] = v.p.x;
        y[k][i] = v.p.y;
        nearness[k][i] = v.nearness;
    }
};

void Batch::load(const Triangles& triangles, const std::uint32_t* places, int last) {
    for (int i = 0; i < batch_size; ++i) {
        // Without a branch: triangles of both windings are mixed.
        const int second = places[lesser(i, last)] & turned ? 2 : 1;
        const std::uint32_t place = places[lesser(i, last)] & ~turned;
        const SnappedVertex *a, *b, *c;
        if (place < triangles.length) {
            const glm::uvec3& corner = triangles.corners[place];
            a = triangles.vertices + corner.x;
            b = triangles.vertices + corner.y;
            c = triangles.vertices + corner.z;
            id[i] = place;
        } else {
            const SnappedPiece& piece = triangles.pieces[place - triangles.length];
            a = piece.vertex, b = piece.vertex + 1, c = piece.vertex + 2;
            id[i] = static_cast<std::uint32_t>(piece.id);
        }
        put_vertex(0, i, *a);
        put_vertex(second, i, *b);
        put_vertex(3 - second, i, *c);
    }
}

/// Pixels whose samples lie in the bounding box, cut to the tile; shifts floor.
void Batch::set_up_box(const TileSamples& tile) {
    const std::int32_t offset = tile.sample_offset, bits = tile.subpixel_bits;
    const std::int32_t before_next = (std::int32_t{1} << bits) - 1;
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t left = lesser(lesser(x[0][i], x[1][i]), x[2][i]);
        const std::int32_t right = greater_of(greater_of(x[0][i], x[1][i]), x[2][i]);
        const std::int32_t top = lesser(lesser(y[0][i], y[1][i]), y[2][i]);
        const std::int32_t bottom = greater_of(greater_of(y[0][i], y[1][i]), y[2][i]);
        column0[i] = greater_of(((left - offset + before_next) >> bits) - tile.x0, 0);
        column1[i] = lesser(((right - offset) >> bits) - tile.x0, tile_size - 1);
        row0[i] = greater_of(((top - offset + before_next) >> bits) - tile.y0, 0);
        row1[i] = lesser(((bottom - offset) >> bits) - tile.y0, tile_size - 1);
        extent[i] = greater_of(right - left, bottom - top);
    }
}

void Batch::set_up_weights() {
    for (int i = 0; i < batch_size; ++i) {
        const double doubled_area = double(x[2][i] - x[1][i]) * double(y[0][i] - y[1][i]) -
                                    double(y[2][i] - y[1][i]) * double(x[0][i] - x[1][i]);
        weight[0][i] = nearness[0][i] / doubled_area;
        weight[1][i] = nearness[1][i] / doubled_area;
        weight[2][i] = nearness[2][i] / doubled_area;
    }
}
