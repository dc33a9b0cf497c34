// The stages of a frame, once for every instruction set: included by kernel_<isa>.cpp within its own unnamed
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

constexpr std::int32_t lesser(std::int32_t a, std::int32_t b) { return a < b ? a : b; }
constexpr std::int32_t greater_of(std::int32_t a, std::int32_t b) { return a > b ? a : b; }
constexpr double greater_of(double a, double b) { return a > b ? a : b; }
constexpr double lesser(double a, double b) { return a < b ? a : b; }
constexpr double magnitude(double a) { return a < 0 ? -a : a; }

/// Without branches, for vectors.
constexpr bool is_top_left(std::int32_t dx, std::int32_t dy) { return (dy < 0) | ((dy == 0) & (dx > 0)); }

// In the order of use.
// clang-format off
#include "rasterizer/vertices.inl"
#include "rasterizer/placing.inl"
#include "rasterizer/batch.inl"
#include "rasterizer/edges.inl"
#include "rasterizer/small_triangles.inl"
#include "rasterizer/cover.inl"
#include "rasterizer/nearness.inl"
#include "rasterizer/scan.inl"
#include "rasterizer/visits.inl"
#include "rasterizer/resolve.inl"
// clang-format on

/// In the order of drawing.
template <class Visit>
void draw_batch(const TileWork& work, const Batch& batch, int count, const Visit& visit) {
    const unsigned is_small = negative_lanes(load(batch.is_small));
    SmallTriangles small;
    if (is_small != 0) small.cover(batch, work.samples);
    Edges edges;
    if (is_small != 0xFFFF) edges.set_up(batch, work.samples);
    for (int i = 0; i < count; ++i) {
        if (is_small >> i & 1)
            visit.small_triangle(batch, small, i, work.pixels);
        else
            scan_triangle(work, batch, edges, i, visit);
    }
}

/// Has the vertices of the batch from here fetched, and the corners of the batch after it, where they do not
/// follow those before.
void fetch_ahead(const TileWork& work, std::uint32_t first) {
    constexpr std::uint32_t near = 16;
    const Triangles& triangles = work.triangles;
    const auto for_each_jump = [&](std::uint32_t from, const auto& visit) {
        for (std::uint32_t i = from; i < from + batch_size && i < work.count; ++i) {
            const std::uint32_t place = work.places[i] & ~turned, before = work.places[i - 1] & ~turned;
            if (place - before > near && place < triangles.length) visit(triangles.corners + place);
        }
    };
    for_each_jump(first, [&](const glm::uvec3* corners) {
        __builtin_prefetch(triangles.vertices + corners->x);
        __builtin_prefetch(triangles.vertices + corners->y);
        __builtin_prefetch(triangles.vertices + corners->z);
    });
    for_each_jump(first + batch_size, [](const glm::uvec3* corners) { __builtin_prefetch(corners); });
}

template <class Visit>
void for_each_triangle(const TileWork& work) {
    const Visit visit(work);
    Batch batch;
    for (std::uint32_t first = 0; first < work.count; first += batch_size) {
        const int last = lesser(batch_size, std::int32_t(work.count - first)) - 1;
        fetch_ahead(work, first + batch_size);
        batch.load(work.triangles, work.places + first, last);
        batch.set_up_box(work.samples);
        batch.set_up_weights();
        draw_batch(work, batch, last + 1, visit);
    }
}

[[gnu::flatten]] void draw(const TileWork& work) noexcept { for_each_triangle<Draw>(work); }
void count(const TileWork& work) noexcept { for_each_triangle<Count>(work); }
void draw_every_block(const TileWork& work) noexcept { for_each_triangle<DrawEveryBlock>(work); }
void draw_tallied(const TileWork& work) noexcept { for_each_triangle<DrawTallied>(work); }
void draw_shaded(const TileWork& work) { for_each_triangle<DrawShaded>(work); }
