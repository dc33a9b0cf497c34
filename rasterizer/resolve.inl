// A tile's pixels into the frame: out of blocks into rows, nearness into camera depth.

struct TileRow {
    alignas(64) float nearness[tile_size];
    alignas(64) std::uint32_t primitive[tile_size];
};

/// Four pixels of a block at a time.
void take_row(TileRow& row, const TilePixels& pixels, int y) {
    for (int x = 0; x < tile_size; x += 4) {
        __builtin_memcpy(row.nearness + x, pixels.nearness + place_in_tile(x, y), 4 * sizeof(float));
        __builtin_memcpy(row.primitive + x, pixels.primitive + place_in_tile(x, y), 4 * sizeof(float));
    }
}

void resolve(const ResolveWork& work) noexcept {
    for (int y = 0; y < work.rows; ++y) {
        TileRow row;
        take_row(row, work.pixels, y);
        float* const depth = work.camera_depth + work.stride * std::size_t(y);
        PrimitiveId* const id = work.primitive + work.stride * std::size_t(y);
        const DepthFunctional functional = work.depth;
        for (int x = 0; x < tile_size; ++x) {
            const float at_pixel = functional.depth_of(row.nearness[x]);
            row.nearness[x] = row.nearness[x] > nothing_seen ? at_pixel : background_depth;
        }
        __builtin_memcpy(depth, row.nearness, std::size_t(work.columns) * sizeof(float));
        __builtin_memcpy(id, row.primitive, std::size_t(work.columns) * sizeof(float));
    }
}
