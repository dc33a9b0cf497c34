// The stages of a frame, once for every instruction set: included by kernel_<isa>.cpp within its own unnamed
// namespace, after its sixteen lanes (Doubles, Floats, Mask and what can be done with them). Nothing of the
// standard library is called: an inline function compiled here would serve the whole program.
//
// Depth at a sample is N = (E0 N0 + E1 N1 + E2 N2) / 2A, the E exact integers held in doubles, the N inverse
// depth at the vertices. Of a covered sample all E are >= 0 and for perspective all N are > 0: nothing
// cancels, so six roundings (1/depth, N / 2A, product, two sums) leave N within a few 2^-53 of the affine
// interpolant, relatively. For parallel projections the same holds of the greatest |depth| of the triangle.
// Then N is rounded once to float32.
//
// E is never rounded. Points of the guard band are 2^24 grid steps from the origin, and so is every pixel of
// a tile that an image edge cuts (2^15 px + 64 px on the 24.8 grid). Differences are <= 2^25, products of two
// <= 2^50, their sum and every E <= 2^51; a step to another pixel of the tile is a whole number, too, and
// each sum on the way there is E at some point of the tile. All that a double holds exactly (< 2^53), so it
// does not matter in which order, or how wide, it is computed.

constexpr std::int32_t min(std::int32_t a, std::int32_t b) { return a < b ? a : b; }
constexpr std::int32_t max(std::int32_t a, std::int32_t b) { return a > b ? a : b; }
constexpr double max(double a, double b) { return a > b ? a : b; }
constexpr double min(double a, double b) { return a < b ? a : b; }

/// Has no branches, for vectors.
constexpr bool is_top_left(std::int32_t dx, std::int32_t dy) { return (dy < 0) | ((dy == 0) & (dx > 0)); }

// The files are included in the order of use.
// clang-format off
#include "rasterizer/vertices.inl"
#include "rasterizer/placing.inl"
#include "rasterizer/batch.inl"
#include "rasterizer/edges.inl"
#include "rasterizer/small_triangles.inl"
#include "rasterizer/cover.inl"
#include "rasterizer/inverse_depth.inl"
#include "rasterizer/scan.inl"
#include "rasterizer/visits.inl"
#include "rasterizer/resolve.inl"
// clang-format on

constexpr std::int64_t fetched_ahead = 2 * batch_size;

/// Has the vertices of a triangle some way after the i-th fetched, and the corners of that as far again.
/// Inlined, or gcc 12 takes it for a function without effects and leaves it out.
[[gnu::always_inline]] inline void fetch_ahead(const TileWork& work, std::int64_t i) {
    const Triangles& triangles = work.triangles;
    const auto corners_at = [&](std::int64_t at) __attribute__((always_inline))->const glm::uvec3* {
        if (at < 0 || at >= work.count) return nullptr;
        const std::uint32_t place = work.entries[at] & ~turned;
        return place < triangles.length ? triangles.corners + place : nullptr;
    };
    if (const glm::uvec3* const corners = corners_at(i + fetched_ahead)) {
        __builtin_prefetch(triangles.vertices + corners->x);
        __builtin_prefetch(triangles.vertices + corners->y);
        __builtin_prefetch(triangles.vertices + corners->z);
    }
    if (const glm::uvec3* const corners = corners_at(i + 2 * fetched_ahead)) __builtin_prefetch(corners);
}

/// Visits the triangles of a batch in the order of drawing.
template <class Visit>
void draw_batch(const TileWork& work, const Batch& batch, std::int64_t first, int count, const Visit& visit) {
    const unsigned is_small = negative_lanes(load(batch.is_small));
    SmallTriangles small;
    if (is_small != 0) small.cover(batch, work.samples);
    Edges edges;
    if (is_small != 0xFFFF) edges.set_up(batch, work.samples);
    for (int i = 0; i < count; ++i) fetch_ahead(work, first + i);
    for (int i = 0; i < count;) {
        const int from = i;
        i = min(i + __builtin_ctz(~is_small >> i), count);
        if (i > from) visit.small_triangles(batch, small, from, i, work.pixels);
        if (i < count) scan_triangle(work, batch, edges, i++, visit);
    }
}

/// Is the tile nearer than all that is left from a batch on?
bool is_finished(const TileWork& work, std::int64_t first) {
    if (work.nearest_left == nullptr) return false;
    return work.nearest_left[first / batch_size] < least_of(load(work.pixels.hiz_of_cell));
}

template <class Visit>
void for_each_triangle(const TileWork& work) {
    const Visit visit(work);
    Batch batch;
    for (std::int64_t i = -2 * fetched_ahead; i < 0; ++i) fetch_ahead(work, i);
    for (std::int64_t first = 0; first < work.count; first += batch_size) {
        if (Visit::hidden_cells == HiddenCells::passed_over && is_finished(work, first)) return;
        const int last = (work.count - first < batch_size ? int(work.count - first) : batch_size) - 1;
        batch.load(work.triangles, work.entries + first, last);
        batch.set_up_box(work.samples);
        batch.set_up_weights();
        draw_batch(work, batch, first, last + 1, visit);
    }
}

void clear(TilePixels& pixels, std::uint32_t primitive) noexcept {
    for (float& inverse_depth : pixels.inverse_depth) inverse_depth = nothing_seen;
    for (std::uint32_t& id : pixels.primitive) id = primitive;
    for (float& hiz : pixels.hiz) hiz = nothing_seen;
    for (float& hiz : pixels.hiz_of_cell) hiz = nothing_seen;
}

[[gnu::flatten, gnu::noinline]] void draw_in_order(const TileWork& work) noexcept {
    for_each_triangle<Draw<Ties::first_to_come>>(work);
}
[[gnu::flatten, gnu::noinline]] void draw_in_any_order(const TileWork& work) noexcept {
    for_each_triangle<Draw<Ties::least_id>>(work);
}
void draw(const TileWork& work) noexcept {
    work.ties == Ties::first_to_come ? draw_in_order(work) : draw_in_any_order(work);
}
void count(const TileWork& work) noexcept { for_each_triangle<Count>(work); }
void draw_every_block(const TileWork& work) noexcept { for_each_triangle<DrawEveryBlock>(work); }
void draw_tallied(const TileWork& work) noexcept {
    work.ties == Ties::first_to_come ? for_each_triangle<DrawTallied<Ties::first_to_come>>(work)
                                     : for_each_triangle<DrawTallied<Ties::least_id>>(work);
}
void draw_shaded(const TileWork& work) { for_each_triangle<DrawShaded>(work); }
