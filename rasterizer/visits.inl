// What is done where a triangle may be seen. `block` is called for blocks that a larger triangle may cover
// and in which it may be nearer; `small_triangles` for whole small ones.

/// Calls visit(index) for the pixels that the small triangles from the one to before the other cover.
template <class Visit>
[[gnu::always_inline]] inline void for_each_fragment(const SmallTriangles& small, int from, int to,
                                                     const Visit& visit) {
    for (int f = small.first[from]; f < small.first[to]; ++f) visit(unsigned(small.fragment[f]));
}

/// A pixel that a small triangle covers.
struct Fragment {
    int column, row;  ///< of the tile
    std::uint32_t id;

    Fragment(const Batch& batch, unsigned index) {
        const unsigned i = index % batch_size, pixel = index / batch_size;
        column = batch.column0[i] + int(pixel) % small_side;
        row = batch.row0[i] + int(pixel) / small_side;
        id = batch.id[i];
    }
};

/// Depth test of one pixel.
template <Ties ties>
bool draw_pixel(TilePixels& pixels, int place, float seen, std::uint32_t id) {
    const float before = pixels.inverse_depth[place];
    const bool wins_tie = ties == Ties::least_id && seen == before && id < pixels.primitive[place];
    if (!(seen > before) && !wins_tie) return false;
    pixels.inverse_depth[place] = seen;
    pixels.primitive[place] = id;
    return true;
}

template <Ties ties>
bool draw_fragment(const Batch& batch, const SmallTriangles& small, unsigned index, TilePixels& pixels) {
    return draw_pixel<ties>(pixels, small.place[index / batch_size][index % batch_size],
                            small.seen[index / batch_size][index % batch_size], batch.id[index % batch_size]);
}

template <Ties ties>
void draw_small(const Batch& batch, const SmallTriangles& small, int from, int to, TilePixels& pixels) {
    for_each_fragment(small, from, to,
                      [&](unsigned index) { draw_fragment<ties>(batch, small, index, pixels); });
}

template <Ties of_equal_depth>
struct Draw {
    static constexpr HiddenCells hidden_cells = HiddenCells::passed_over;
    static constexpr Ties ties = of_equal_depth;

    explicit Draw(const TileWork&) {}
    void leave_out(unsigned) const {}
    template <class Covered>
    void block(TilePixels& pixels, const Block& block, const Floats& seen, const Covered& covered) const {
        draw_block<ties>(pixels, block, seen, covered);
    }
    void drawn(TilePixels& pixels, int place, unsigned blocks) const { update_hiz(pixels, place, blocks); }
    void small_triangles(const Batch& batch, const SmallTriangles& small, int from, int to,
                         TilePixels& pixels) const {
        draw_small<ties>(batch, small, from, to, pixels);
    }
};

/// What is farthest is never noted, so that no block is hidden.
struct DrawEveryBlock {
    static constexpr HiddenCells hidden_cells = HiddenCells::visited;
    static constexpr Ties ties = Ties::first_to_come;

    explicit DrawEveryBlock(const TileWork&) {}
    void leave_out(unsigned) const {}
    template <class Covered>
    void block(TilePixels& pixels, const Block& block, const Floats& seen, const Covered& covered) const {
        draw_block<ties>(pixels, block, seen, covered);
    }
    void drawn(TilePixels&, int, unsigned) const {}
    void small_triangles(const Batch& batch, const SmallTriangles& small, int from, int to,
                         TilePixels& pixels) const {
        draw_small<ties>(batch, small, from, to, pixels);
    }
};

bool is_in_image(const TileSamples& tile, int x, int y) { return x < tile.columns && y < tile.rows; }

/// Which pixels of a block are the image's.
unsigned within_image(const TileSamples& tile, const Block& block) {
    unsigned bits = 0;
    for (int i = 0; i < 16; ++i) bits |= (is_in_image(tile, block.x + i % 4, block.y + i / 4) ? 1u : 0u) << i;
    return bits;
}

unsigned count_of(unsigned bits) { return unsigned(__builtin_popcount(bits)); }

template <Ties of_equal_depth>
struct DrawTallied {
    static constexpr HiddenCells hidden_cells = HiddenCells::visited;
    static constexpr Ties ties = of_equal_depth;
    Tally& tally;
    HierarchicalZ hierarchical_z;
    const TileSamples& tile;

    explicit DrawTallied(const TileWork& work)
        : tally(*work.tally), hierarchical_z(work.hierarchical_z), tile(work.samples) {}
    void leave_out(unsigned blocks) const {
        tally.blocks += count_of(blocks);
        tally.hidden_blocks += count_of(blocks);
    }
    template <class Covered>
    void block(TilePixels& pixels, const Block& block, const Floats& seen, const Covered& is_covered) const {
        const PassedPixels won = draw_block<ties>(pixels, block, seen, is_covered);
        const unsigned image = within_image(tile, block);
        tally.blocks += 1;
        tally.fragments += count_of(won.covered & image);
        tally.written += count_of(won.nearer & image);
    }
    void drawn(TilePixels& pixels, int place, unsigned blocks) const {
        if (hierarchical_z == HierarchicalZ::blocks) update_hiz(pixels, place, blocks);
    }
    void small_triangles(const Batch& batch, const SmallTriangles& small, int from, int to,
                         TilePixels& pixels) const {
        for (int i = from; i < to; ++i) tally.blocks += blocks_met(batch, i);
        for_each_fragment(small, from, to, [&](unsigned index) {
            const bool is_nearer = draw_fragment<ties>(batch, small, index, pixels);
            const Fragment fragment(batch, index);
            if (!is_in_image(tile, fragment.column, fragment.row)) return;
            tally.fragments += 1;
            tally.written += is_nearer ? 1 : 0;
        });
    }
    static unsigned blocks_met(const Batch& batch, int i) {
        const int columns = batch.column1[i] / 4 - batch.column0[i] / 4 + 1;
        const int rows = batch.row1[i] / 4 - batch.row0[i] / 4 + 1;
        return unsigned(columns * rows);
    }
};

struct DrawShaded {
    static constexpr HiddenCells hidden_cells = HiddenCells::visited;
    static constexpr Ties ties = Ties::first_to_come;
    const FragmentShader& shader;
    HierarchicalZ hierarchical_z;
    const TileSamples& tile;

    explicit DrawShaded(const TileWork& work)
        : shader(*work.shader), hierarchical_z(work.hierarchical_z), tile(work.samples) {}
    void leave_out(unsigned) const {}
    bool is_late() const { return shader.time == ShadingTime::before_the_test; }
    void shade(std::uint32_t id, int column, int row, DepthTestResult result) const {
        shader.shade(shader.context, PrimitiveId{id}, tile.x0 + column, tile.y0 + row, result);
    }
    template <class Covered>
    void block(TilePixels& pixels, const Block& block, const Floats& seen, const Covered& is_covered) const {
        const PassedPixels won = draw_block<ties>(pixels, block, seen, is_covered);
        const unsigned shaded = (is_late() ? won.covered : won.nearer) & within_image(tile, block);
        for (unsigned left = shaded; left != 0; left &= left - 1) {
            const int i = __builtin_ctz(left);
            shade(block.id, block.x + i % 4, block.y + i / 4,
                  won.nearer >> i & 1 ? DepthTestResult::kept : DepthTestResult::discarded);
        }
    }
    void drawn(TilePixels& pixels, int place, unsigned blocks) const {
        if (hierarchical_z == HierarchicalZ::blocks) update_hiz(pixels, place, blocks);
    }
    void small_triangles(const Batch& batch, const SmallTriangles& small, int from, int to,
                         TilePixels& pixels) const {
        for_each_fragment(small, from, to, [&](unsigned index) {
            const bool is_nearer = draw_fragment<ties>(batch, small, index, pixels);
            const Fragment fragment(batch, index);
            if ((is_late() || is_nearer) && is_in_image(tile, fragment.column, fragment.row))
                shade(fragment.id, fragment.column, fragment.row,
                      is_nearer ? DepthTestResult::kept : DepthTestResult::discarded);
        });
    }
};

struct Count {
    static constexpr HiddenCells hidden_cells = HiddenCells::visited;
    static constexpr Ties ties = Ties::first_to_come;

    explicit Count(const TileWork&) {}
    void leave_out(unsigned) const {}
    template <class Covered>
    void block(TilePixels& pixels, const Block& block, const Floats&, const Covered& is_covered) const {
        const unsigned covered = is_covered.covered();
        for (unsigned i = 0; i < 16; ++i) pixels.primitive[16 * block.place + int(i)] += covered >> i & 1;
    }
    void drawn(TilePixels&, int, unsigned) const {}
    void small_triangles(const Batch&, const SmallTriangles& small, int from, int to,
                         TilePixels& pixels) const {
        for_each_fragment(small, from, to, [&](unsigned index) {
            ++pixels.primitive[small.place[index / batch_size][index % batch_size]];
        });
    }
};
