// The scan of a tile, once for every instruction set: included by kernel_<isa>.cpp within its own unnamed
// namespace, after its sixteen lanes (Doubles, Floats, Mask and what can be done with them). Nothing of the
// standard library is called: an inline function compiled here would serve the whole program.
//
// Depth at a sample is N = (E0 N0 + E1 N1 + E2 N2) / 2A, the E exact integers held in doubles, the N nearness
// at the vertices. Of a covered sample all E are >= 0 and for perspective all N are > 0: nothing cancels, so
// six roundings (1/depth, N / 2A, product, two sums) leave N within a few 2^-53 of the affine interpolant,
// relatively. For parallel projections the same holds of the greatest |depth| of the triangle. Then N is
// rounded once to float32.
//
// E is never rounded. Points of the guard band are 2^24 grid steps from the origin, and so is every pixel of
// a tile that an image edge cuts (2^15 px + 64 px on the 24.8 grid). Differences are <= 2^25, products of two
// <= 2^50, their sum and every E <= 2^51; a step to another pixel of the tile is a whole number, too, and
// each sum on the way there is E at some point of the tile. All that a double holds exactly (< 2^53), so it
// does not matter in which order, or how wide, it is computed.

constexpr int batch_size = 8;

constexpr std::int32_t lesser(std::int32_t a, std::int32_t b) { return a < b ? a : b; }
constexpr std::int32_t greater_of(std::int32_t a, std::int32_t b) { return a > b ? a : b; }
constexpr double greater_of(double a, double b) { return a > b ? a : b; }
constexpr double magnitude(double a) { return a < 0 ? -a : a; }
constexpr bool is_top_left(std::int32_t dx, std::int32_t dy) { return dy < 0 || (dy == 0 && dx > 0); }

/// Triangles side by side, so that they are set up together. [k] is a vertex, or the edge opposite to it.
struct Batch {
    alignas(64) std::int32_t x[3][batch_size], y[3][batch_size];
    alignas(64) double nearness[3][batch_size];
    alignas(64) std::uint32_t id[batch_size];

    alignas(64) double e[3][batch_size];                    ///< E at the sample of the tile's first pixel
    alignas(64) double a[3][batch_size], b[3][batch_size];  ///< step of E to the next column, row
    alignas(64) double least[3][batch_size];                ///< the least E that is covered
    alignas(64) double weight[3][batch_size];               ///< nearness of vertex k, divided by 2A
    alignas(64) float nearest[batch_size];                  ///< no pixel gets more
    alignas(64) std::int32_t column0[batch_size],
        column1[batch_size];  ///< of the box in the tile: first, last
    alignas(64) std::int32_t row0[batch_size], row1[batch_size];

    void put_vertex(int k, int i, const SnappedVertex& v) {
        x[k][i] = v.p.x;
        y[k][i] = v.p.y;
        nearness[k][i] = v.nearness;
    }
    void load(const TriangleRun& run, std::uint32_t place, int i);
    void set_up(const TileSamples& tile);
    void set_up_edge(int k, const TileSamples& tile);
    void set_up_weights();
    void set_up_box(const TileSamples& tile);
};

void Batch::load(const TriangleRun& run, std::uint32_t place, int i) {
    const int second = place & turned ? 2 : 1;
    place &= ~turned;
    if (place < run.length) {
        const glm::uvec3& corner = run.corners[place];
        put_vertex(0, i, run.vertices[corner.x]);
        put_vertex(second, i, run.vertices[corner.y]);
        put_vertex(3 - second, i, run.vertices[corner.z]);
        id[i] = run.first + place;
        return;
    }
    const SnappedPiece& piece = run.pieces[place - run.length];
    put_vertex(0, i, piece.vertex[0]);
    put_vertex(second, i, piece.vertex[1]);
    put_vertex(3 - second, i, piece.vertex[2]);
    id[i] = static_cast<std::uint32_t>(piece.id);
}

/// E(p) = dx (p.y - from.y) - dy (p.x - from.x). 0.0 turns a -0 into the 0 that integers know.
void Batch::set_up_edge(int k, const TileSamples& tile) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const std::int32_t steps = std::int32_t{1} << tile.subpixel_bits;
    const std::int32_t sample_x = tile.x0 * steps + tile.sample_offset;
    const std::int32_t sample_y = tile.y0 * steps + tile.sample_offset;
    for (int i = 0; i < batch_size; ++i) {
        const std::int32_t dx = x[to][i] - x[from][i], dy = y[to][i] - y[from][i];
        e[k][i] =
            (double(dx) * double(sample_y - y[from][i]) - double(dy) * double(sample_x - x[from][i])) + 0.0;
        a[k][i] = -double(dy) * double(steps);
        b[k][i] = double(dx) * double(steps);
        least[k][i] = double(is_top_left(dx, dy) ? tile.least_of_top_left : tile.least_of_others);
    }
}

/// A covered pixel gets at most max N + 4u max |N| (u = 2^-53, of three roundings per term and the
/// quotient's; what underflow adds is lost in the rounding to float32). 2^-50 is twice that, for this sum's
/// own rounding. Rounding to float32 keeps the order.
void Batch::set_up_weights() {
    for (int i = 0; i < batch_size; ++i) {
        const double doubled_area = double(x[2][i] - x[1][i]) * double(y[0][i] - y[1][i]) -
                                    double(y[2][i] - y[1][i]) * double(x[0][i] - x[1][i]);
        const double n0 = nearness[0][i], n1 = nearness[1][i], n2 = nearness[2][i];
        weight[0][i] = n0 / doubled_area;
        weight[1][i] = n1 / doubled_area;
        weight[2][i] = n2 / doubled_area;
        const double most = greater_of(n0, greater_of(n1, n2));
        const double largest = greater_of(magnitude(n0), greater_of(magnitude(n1), magnitude(n2)));
        nearest[i] = float(most + 0x1p-50 * largest);
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
    }
}

void Batch::set_up(const TileSamples& tile) {
    for (int k = 0; k < 3; ++k) set_up_edge(k, tile);
    set_up_weights();
    set_up_box(tile);
}

alignas(64) constexpr double lane_column[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr double lane_row[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// One triangle in one tile. Lane i is column i % 4, row i / 4, of a block of pixels or of blocks.
struct Scan {
    Doubles offset[3];  ///< of E, from lane 0
    double e[3], a[3], b[3], least[3], weight[3];
    float nearest;
    std::uint32_t id;

    Scan(const Batch& batch, int i) : nearest(batch.nearest[i]), id(batch.id[i]) {
        for (int k = 0; k < 3; ++k) {
            e[k] = batch.e[k][i];
            a[k] = batch.a[k][i];
            b[k] = batch.b[k][i];
            least[k] = batch.least[k][i];
            weight[k] = batch.weight[k][i];
            offset[k] = load(lane_column) * a[k] + load(lane_row) * b[k];
        }
    }
    /// E of edge k at pixel (x, y) of the tile.
    double at(int k, int x, int y) const { return (e[k] + a[k] * x) + b[k] * y; }
};

/// Bit i: pixel i of a block.
struct Won {
    unsigned covered, nearer;
};

/// Depth test, depth and id of the pixels of a block; (x, y) is the block's place in the tile.
Won draw_block(const Scan& scan, TilePixels& pixels, int place, int x, int y) {
    const Doubles e0 = all(scan.at(0, x, y)) + scan.offset[0];
    const Doubles e1 = all(scan.at(1, x, y)) + scan.offset[1];
    const Doubles e2 = all(scan.at(2, x, y)) + scan.offset[2];
    const auto inside =
        at_least(e0, scan.least[0]) & at_least(e1, scan.least[1]) & at_least(e2, scan.least[2]);
    const unsigned covered = bits_of(inside);
    if (covered == 0) return {0, 0};
    const Floats seen = rounded((e0 * scan.weight[0] + e1 * scan.weight[1]) + e2 * scan.weight[2]);
    float* const nearness = pixels.nearness + 16 * place;
    const Floats held = load(nearness);
    const auto wins = narrowed(inside) & greater(seen, held);
    put(nearness, wins, seen);
    put(pixels.primitive + 16 * place, wins, scan.id);
    return {covered, bits_of(wins)};
}

bool is_hidden(const Scan& scan, const TilePixels& pixels, int place) {
    return !(scan.nearest > pixels.farthest[place]);
}

void note_farthest(TilePixels& pixels, int place, unsigned covered) {
    const float* const nearness = pixels.nearness + 16 * place;
    if (covered == 0xFFFF) pixels.farthest[place] = least_of(load(nearness));
}

struct Draw {
    explicit Draw(const TileWork&) {}
    void leave_out(unsigned) const {}
    void block(const Scan& scan, TilePixels& pixels, int place, int x, int y) const {
        if (is_hidden(scan, pixels, place)) return;
        note_farthest(pixels, place, draw_block(scan, pixels, place, x, y).covered);
    }
};

/// What is farthest is never noted, so that no block is hidden.
struct DrawEveryBlock {
    explicit DrawEveryBlock(const TileWork&) {}
    void leave_out(unsigned) const {}
    void block(const Scan& scan, TilePixels& pixels, int place, int x, int y) const {
        draw_block(scan, pixels, place, x, y);
    }
};

/// Which pixels of the block at (x, y) of the tile are the image's.
unsigned within_image(const TileSamples& tile, int x, int y) {
    unsigned bits = 0;
    for (int i = 0; i < 16; ++i) bits |= (x + i % 4 < tile.columns && y + i / 4 < tile.rows ? 1u : 0u) << i;
    return bits;
}

unsigned count_of(unsigned bits) { return unsigned(__builtin_popcount(bits)); }

struct DrawTallied {
    Tally& tally;
    HierarchicalZ hierarchical_z;
    const TileSamples& tile;

    explicit DrawTallied(const TileWork& work)
        : tally(*work.tally), hierarchical_z(work.hierarchical_z), tile(work.samples) {}
    void leave_out(unsigned blocks) const {
        tally.blocks += count_of(blocks);
        tally.hidden_blocks += count_of(blocks);
    }
    void block(const Scan& scan, TilePixels& pixels, int place, int x, int y) const {
        if (is_hidden(scan, pixels, place)) return leave_out(1);
        const Won won = draw_block(scan, pixels, place, x, y);
        const unsigned image = within_image(tile, x, y);
        tally.blocks += 1;
        tally.fragments += count_of(won.covered & image);
        tally.written += count_of(won.nearer & image);
        if (hierarchical_z == HierarchicalZ::blocks) note_farthest(pixels, place, won.covered);
    }
};

struct DrawShaded {
    const FragmentShader& shader;
    HierarchicalZ hierarchical_z;
    const TileSamples& tile;

    explicit DrawShaded(const TileWork& work)
        : shader(*work.shader), hierarchical_z(work.hierarchical_z), tile(work.samples) {}
    void leave_out(unsigned) const {}
    void block(const Scan& scan, TilePixels& pixels, int place, int x, int y) const {
        if (is_hidden(scan, pixels, place)) return;
        const Won won = draw_block(scan, pixels, place, x, y);
        const bool late = shader.time == ShadingTime::before_the_test;
        const unsigned shaded = (late ? won.covered : won.nearer) & within_image(tile, x, y);
        for (unsigned left = shaded; left != 0; left &= left - 1) {
            const int i = __builtin_ctz(left);
            shader.shade(shader.stage, PrimitiveId{scan.id}, tile.x0 + x + i % 4, tile.y0 + y + i / 4,
                         won.nearer >> i & 1 ? Fate::kept : Fate::discarded);
        }
        if (hierarchical_z == HierarchicalZ::blocks) note_farthest(pixels, place, won.covered);
    }
};

struct Count {
    explicit Count(const TileWork&) {}
    void leave_out(unsigned) const {}
    void block(const Scan& scan, TilePixels& pixels, int place, int x, int y) const {
        const auto inside = at_least(all(scan.at(0, x, y)) + scan.offset[0], scan.least[0]) &
                            at_least(all(scan.at(1, x, y)) + scan.offset[1], scan.least[1]) &
                            at_least(all(scan.at(2, x, y)) + scan.offset[2], scan.least[2]);
        const unsigned covered = bits_of(inside);
        for (unsigned i = 0; i < 16; ++i) pixels.primitive[16 * place + int(i)] += covered >> i & 1;
    }
};

/// Of 16 blocks, bit by bit.
struct Blocks {
    unsigned met;   ///< may have covered pixels
    unsigned open;  ///< of those, may have pixels that can win
};

/// Of the 16 blocks from pixel (x, y): E is affine, so of each block the corner decides that lies farthest
/// inwards.
Blocks blocks_reached(const Scan& scan, const TilePixels& pixels, int x, int y) {
    const auto reached = [&](int k) {
        const double to_corner = 3 * (greater_of(scan.a[k], 0.0) + greater_of(scan.b[k], 0.0));
        return at_least(all(scan.at(k, x, y) + to_corner) + scan.offset[k] * 4.0, scan.least[k]);
    };
    const unsigned inside = bits_of(reached(0) & reached(1) & reached(2));
    const float* const farthest = pixels.farthest + (y / 16 * 4 + x / 16) * 16;
    return {inside, inside & bits_of(greater(all(scan.nearest), load(farthest)))};
}

template <class Visit>
void scan_large(const Scan& scan, TilePixels& pixels, const Batch& batch, int i, const Visit& visit) {
    for (int y = batch.row0[i] & ~15; y <= batch.row1[i]; y += 16) {
        for (int x = batch.column0[i] & ~15; x <= batch.column1[i]; x += 16) {
            const int first = (y / 16 * 4 + x / 16) * 16;
            const Blocks blocks = blocks_reached(scan, pixels, x, y);
            visit.leave_out(blocks.met & ~blocks.open);
            for (unsigned left = blocks.open; left != 0; left &= left - 1) {
                const int block = __builtin_ctz(left);
                visit.block(scan, pixels, first + block, x + block % 4 * 4, y + block / 4 * 4);
            }
        }
    }
}

template <class Visit>
void scan_triangle(TilePixels& pixels, const Batch& batch, int i, const Visit& visit) {
    const Scan scan(batch, i);
    const int x0 = batch.column0[i] & ~3, x1 = batch.column1[i] & ~3;
    const int y0 = batch.row0[i] & ~3, y1 = batch.row1[i] & ~3;
    if (x1 - x0 > 4 || y1 - y0 > 4) return scan_large(scan, pixels, batch, i, visit);
    for (int y = y0; y <= y1; y += 4)
        for (int x = x0; x <= x1; x += 4)
            visit.block(scan, pixels, (y / 16 * 4 + x / 16) * 16 + y / 4 % 4 * 4 + x / 4 % 4, x, y);
}

/// A batch is filled up with its last triangle.
template <class Visit>
void for_each_triangle(const TileWork& work) {
    const Visit visit(work);
    Batch batch;
    for (std::uint32_t first = 0; first < work.count; first += batch_size) {
        const int last = lesser(batch_size, std::int32_t(work.count - first)) - 1;
        for (int i = 0; i < batch_size; ++i)
            batch.load(work.run, work.places[first + std::uint32_t(lesser(i, last))], i);
        batch.set_up(work.samples);
        for (int i = 0; i <= last; ++i) scan_triangle(work.pixels, batch, i, visit);
    }
}

void draw(const TileWork& work) noexcept { for_each_triangle<Draw>(work); }
void count(const TileWork& work) noexcept { for_each_triangle<Count>(work); }
void draw_every_block(const TileWork& work) noexcept { for_each_triangle<DrawEveryBlock>(work); }
void draw_tallied(const TileWork& work) noexcept { for_each_triangle<DrawTallied>(work); }
void draw_shaded(const TileWork& work) { for_each_triangle<DrawShaded>(work); }
