#include "rasterizer/binned_run.h"

#include <algorithm>

#include "rasterizer/triangle_setup.h"

namespace zproof::rasterizer {
namespace {

/// The first and the last sample of a column or row of tiles.
struct Samples {
    std::int32_t first, last;
};

Samples samples_of(int index, int image_pixels, const SubpixelGrid& grid) {
    const int first = index * tile_size;
    const int last = std::min(first + tile_size, image_pixels) - 1;
    return {grid.sample(first), grid.sample(last)};
}

/// E is affine: at one of the ends a term of it is greatest.
std::int64_t greatest(std::int64_t slope, const Samples& samples) {
    return slope * (slope > 0 ? samples.last : samples.first);
}

/// The corners in clockwise order.
Corners corners_of(const CornerLanes& lanes, int i, bool is_turned) {
    const auto& [a, b, c] = lanes.corner;
    return is_turned ? Corners{a[i], c[i], b[i]} : Corners{a[i], b[i], c[i]};
}

}  // namespace

BinTally& BinTally::operator+=(const BinTally& other) {
    triangles += other.triangles;
    outside += other.outside;
    cut += other.cut;
    facing_away += other.facing_away;
    set_up += other.set_up;
    cover_px += other.cover_px;
    return *this;
}

void BinnedRun::fill(const Kernel& kernel, const Scene& scene, const ProjectedVertices& projected,
                     const ViewSetup& setup, const IndexRange& range) {
    kernel_ = &kernel;
    setup_ = &setup;
    tiles_ = TileGrid(setup.size);
    length_ = std::uint32_t(scene.triangles.size());
    tally_ = {.triangles = range.end - range.begin};
    pieces_.clear();
    entry_runs_.clear();
    const SnappedVertex* const v = projected.snapped().data();
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
        const glm::uvec3 index = scene.triangles[i];
        const ClipOutcome outcome = clip_outcome(index, projected.outcode().data());
        if (outcome == ClipOutcome::whole)
            add(v[index.x].p, v[index.y].p, v[index.z].p, i);
        else if (outcome == ClipOutcome::cut)
            add_pieces(scene, i);
        else
            ++tally_.outside;
    }
    place_queue();
    count_in_tiles();
}

void BinnedRun::count_in_tiles() {
    end_entry_run();
    next_.assign(tiles_.count(), 0);
    for (const auto& [tile, count] : entry_runs_) next_[tile] += count;
}

void BinnedRun::add_pieces(const Scene& scene, std::uint32_t triangle) {
    ++tally_.cut;
    const std::size_t first = pieces_.size();
    append_pieces(pieces_, scene, *setup_, triangle);
    for (std::size_t i = first; i < pieces_.size(); ++i) {
        const SnappedVertex(&v)[3] = pieces_[i].vertex;
        add(v[0].p, v[1].p, v[2].p, length_ + std::uint32_t(i));
    }
}

void BinnedRun::add(const SnappedPoint& a, const SnappedPoint& b, const SnappedPoint& c,
                    std::uint32_t place) {
    const int i = queue_.count++;
    queue_.corners.corner[0][i] = a;
    queue_.corners.corner[1][i] = b;
    queue_.corners.corner[2][i] = c;
    queue_.place[i] = place;
    if (queue_.count == CornerLanes::count) place_queue();
}

/// Lanes of the last queue that nobody is in hold a triangle without an area.
void BinnedRun::place_queue() {
    for (auto& corner : queue_.corners.corner)
        std::fill(corner + queue_.count, corner + CornerLanes::count, SnappedPoint{});
    const PlacedLanes placed = kernel_->place(*setup_, queue_.corners);
    tally_.cover_px += placed.cover_px;
    if (queue_.count == CornerLanes::count && placed.in_one_tile)
        return add_queue_to_tile(tiles_.tile_at(placed.column0[0], placed.row0[0]), placed);
    for (int i = 0; i < queue_.count; ++i) {
        const std::uint32_t place = queue_.place[i] | placed.turn[i];
        tally_.facing_away += std::uint64_t(placed.faces_away[i]);
        if (placed.column0[i] > placed.column1[i]) continue;
        ++tally_.set_up;
        if (placed.column0[i] == placed.column1[i] && placed.row0[i] == placed.row1[i])
            add_to_tile(placed.column0[i], placed.row0[i], place);
        else
            add_to_tiles(i, placed, place);
    }
    queue_.count = 0;
}

void BinnedRun::add_queue_to_tile(std::uint32_t tile, const PlacedLanes& placed) {
    go_to(tile);
    std::uint32_t* const entries = entries_.add(CornerLanes::count);
    for (std::size_t i = 0; i < CornerLanes::count; ++i) entries[i] = queue_.place[i] | placed.turn[i];
    tally_.set_up += CornerLanes::count;
    queue_.count = 0;
}

/// A triangle that stays in one row or column of tiles meets every one of them.
void BinnedRun::add_to_tiles(int lane, const PlacedLanes& placed, std::uint32_t place) {
    const int column0 = placed.column0[lane], column1 = placed.column1[lane];
    const int row0 = placed.row0[lane], row1 = placed.row1[lane];
    if (column0 != column1 && row0 != row1) return add_to_tiles_reached(lane, placed, place);
    for (int row = row0; row <= row1; ++row)
        for (int column = column0; column <= column1; ++column) add_to_tile(column, row, place);
}

/// Those that have a sample on the inner side of each edge.
void BinnedRun::add_to_tiles_reached(int lane, const PlacedLanes& placed, std::uint32_t place) {
    const auto edges = edges_of(corners_of(queue_.corners, lane, (place & turned) != 0), setup_->fill);
    for (int row = placed.row0[lane]; row <= placed.row1[lane]; ++row) {
        const Samples y = samples_of(row, setup_->size.height, setup_->grid);
        std::int64_t of_row[3];
        for (std::size_t k = 0; k < 3; ++k) of_row[k] = greatest(edges[k].b, y) + edges[k].c - edges[k].least;
        for (int column = placed.column0[lane]; column <= placed.column1[lane]; ++column) {
            const Samples x = samples_of(column, setup_->size.width, setup_->grid);
            const auto is_reached = [&](std::size_t k) { return greatest(edges[k].a, x) + of_row[k] >= 0; };
            if (is_reached(0) && is_reached(1) && is_reached(2)) add_to_tile(column, row, place);
        }
    }
}

std::size_t BinnedRun::put_pieces_at(std::size_t first) {
    first_piece_ = first;
    return pieces_.size();
}

void BinnedRun::write(std::span<const std::size_t> first, std::span<std::uint32_t> entries,
                      std::span<SnappedPiece> pieces) {
    const std::uint32_t length = length_, first_piece = std::uint32_t(first_piece_);
    const std::uint32_t* from = entries_.data();
    for (const auto& [tile, count] : entry_runs_) {
        std::uint32_t* const to = entries.data() + first[tile] + next_[tile];
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_piece = (from[i] & ~turned) >= length;
            to[i] = is_piece ? from[i] + first_piece : from[i];
        }
        next_[tile] += count;
        from += count;
    }
    std::ranges::copy(pieces_, pieces.begin() + std::ptrdiff_t(first_piece_));
}

}  // namespace zproof::rasterizer
