// How near the pixels of one triangle are, a block of 4 x 4 pixels side by side.

alignas(64) constexpr double lane_x[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr double lane_y[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

struct InverseDepthPlane {
    alignas(64) double of_pixel[3][16];  ///< E from the first pixel of a block to each
    alignas(64) double of_block[3][16];  ///< four times that, from the first block of a square to each
    double e[3], a[3], b[3], weight[3];  ///< E at the tile's first pixel; its step to the next column, row

    InverseDepthPlane(const Batch& batch, const Edges& edges, const TileSamples& tile, int i);

    /// E at the first pixels of a square's blocks.
    struct At {
        alignas(64) double e[3][16];
    };
    /// The square that begins at a pixel of the tile.
    At at(int x, int y) const {
        At square;
        for (int k = 0; k < 3; ++k)
            store(square.e[k], load(of_block[k]) + splat((e[k] + a[k] * double(x)) + b[k] * double(y)));
        return square;
    }
    /// The inverse depths of a block's 16 pixels, covered or not.
    Floats of_pixels(const At& square, int block) const {
        const auto term = [&](int k) { return (splat(square.e[k][block]) + load(of_pixel[k])) * weight[k]; };
        return rounded((term(0) + term(1)) + term(2));
    }
};

InverseDepthPlane::InverseDepthPlane(const Batch& batch, const Edges& edges, const TileSamples& tile, int i) {
    const double steps = std::int32_t{1} << tile.subpixel_bits;
    for (int k = 0; k < 3; ++k) {
        e[k] = edges.e[k][i];
        a[k] = steps * edges.to_column[k][i];
        b[k] = steps * edges.to_row[k][i];
        weight[k] = batch.weight[k][i];
        const Doubles of_pixels = load(lane_x) * a[k] + load(lane_y) * b[k];
        store(of_pixel[k], of_pixels);
        store(of_block[k], of_pixels * 4.0);
    }
}
