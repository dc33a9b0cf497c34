#include "compare/tile_search.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "compare/corner_cells.h"
#include "compare/neighbourhood.h"
#include "compare/triangle_filter.h"

namespace zproof {

namespace {

constexpr std::size_t chunk_triangles = 4096;

/// How many cells before a place, row by row, hold anything that is asked about: any in a rectangle by four
/// look-ups.
class AskedCells {
  public:
    AskedCells(const Cells& cells, const Tiles& tiles, const AskedBoxes& asked)
        : width_(std::size_t(cells.columns) + 1), sums_(width_ * (std::size_t(cells.rows) + 1)) {
        for (std::size_t tile = 0; tile < tiles.count(); ++tile)
            for (const Box& box : asked.of(tile)) mark(cells, box);
        for (int row = 0; row < cells.rows; ++row)
            for (int column = 0; column < cells.columns; ++column)
                at(column + 1, row + 1) += at(column, row + 1) + at(column + 1, row) - at(column, row);
    }
    /// Both ends included.
    bool any(int left, int top, int right, int bottom) const {
        return at(right + 1, bottom + 1) - at(left, bottom + 1) - at(right + 1, top) + at(left, top) != 0;
    }

  private:
    void mark(const Cells& cells, const Box& box) {
        const int right = cells.column_of(box.right), bottom = cells.row_of(box.bottom);
        for (int row = cells.row_of(box.top); row <= bottom; ++row)
            for (int column = cells.column_of(box.left); column <= right; ++column)
                at(column + 1, row + 1) = 1;
    }
    std::uint32_t& at(int column, int row) { return sums_[std::size_t(row) * width_ + std::size_t(column)]; }
    std::uint32_t at(int column, int row) const {
        return sums_[std::size_t(row) * width_ + std::size_t(column)];
    }

    std::size_t width_;
    std::vector<std::uint32_t> sums_;
};

struct Meeting {
    std::uint32_t tile, triangle;
};

/// Finds the tiles that one triangle meets. Its box is asked only where its corners' cells do not say no, and
/// its edges only where its box does not.
class TileSearch {
  public:
    TileSearch(const Scene& scene, const View& view, const AskedBoxes& asked)
        : scene_(scene),
          asked_(asked),
          reach_px_(asked.reach_px()),
          tiles_(view),
          cells_(view),
          asked_cells_(cells_, tiles_, asked),
          projection_(view),
          filters_(view),
          corners_(scene.vertices.position_world.size()) {
        const CornerCells corner_cells(projection_, cells_);
        const std::span<const glm::vec3> p_world = scene.vertices.position_world;
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, p_world.size(), chunk_triangles),
                          [&](const auto& some) {
                              corner_cells.find(p_world.subspan(some.begin(), some.size()),
                                                std::span(corners_).subspan(some.begin(), some.size()));
                          });
    }

    void search(std::uint32_t triangle, std::vector<Meeting>& found) const {
        const glm::uvec3 v = scene_.triangles[triangle];
        const CellReach all = CellReach::of(corners_[v.x], corners_[v.y], corners_[v.z]);
        if (!asked_cells_.any(all.left(), all.top(), all.right(), all.bottom())) return;
        if (const auto box = projection_(corners_of(scene_, triangle))) search(triangle, *box, found);
    }

  private:
    void search(std::uint32_t triangle, const Box& box, std::vector<Meeting>& found) const {
        const double reach = reach_px_;
        const int left = clamped(box.left - reach, tiles_.columns),
                  right = clamped(box.right + reach, tiles_.columns);
        const int top = clamped(box.top - reach, tiles_.rows),
                  bottom = clamped(box.bottom + reach, tiles_.rows);
        std::optional<TriangleFilter> edges;
        const auto may_meet = [&](const Box& asked) {
            if (!box.meets(asked)) return false;
            if (box.fits(Tiles::side_px)) return true;
            if (!edges) edges = filters_.of(corners_of(scene_, triangle));
            return !edges->misses(around(asked));
        };
        for (int row = top; row <= bottom; ++row)
            for (int column = left; column <= right; ++column) {
                const std::size_t tile = tiles_.index(column, row);
                if (std::ranges::any_of(asked_.of(tile), may_meet))
                    found.push_back({std::uint32_t(tile), triangle});
            }
    }
    static int clamped(double px, int count) {
        return int(std::clamp(px / Tiles::side_px, 0.0, count - 1.0));
    }

    const Scene& scene_;
    const AskedBoxes& asked_;
    double reach_px_;
    Tiles tiles_;
    Cells cells_;
    AskedCells asked_cells_;
    BoxProjection projection_;
    TriangleFilters filters_;
    std::vector<CellReach> corners_;
};

}  // namespace

void AskedBoxes::add(std::size_t tile, const Box& square, double reach_px) {
    constexpr std::size_t most = 8;
    std::vector<Box>& boxes = boxes_[tile];
    reach_px_[tile] = std::max(reach_px_[tile], reach_px);
    const auto has_its_place = [&](const Box& b) {
        return b.middle_x() == square.middle_x() && b.middle_y() == square.middle_y();
    };
    if (boxes.size() == most || (!boxes.empty() && has_its_place(boxes.back())))
        boxes.back().add(square);
    else
        boxes.push_back(square);
}

double AskedBoxes::reach_px() const { return reach_px_.empty() ? 0 : std::ranges::max(reach_px_); }

TrianglesByTile::TrianglesByTile(const Scene& scene, const View& view, const AskedBoxes& asked)
    : first_(Tiles(view).count() + 1) {
    const TileSearch tile_search(scene, view, asked);
    const std::size_t count = scene.triangles.size();
    std::vector<std::vector<Meeting>> chunks((count + chunk_triangles - 1) / chunk_triangles);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t chunk) {
        const std::size_t end = std::min(count, (chunk + 1) * chunk_triangles);
        for (std::size_t t = chunk * chunk_triangles; t < end; ++t)
            tile_search.search(std::uint32_t(t), chunks[chunk]);
    });
    for (const auto& chunk : chunks)
        for (const Meeting& m : chunk) ++first_[m.tile + 1];
    for (std::size_t t = 1; t < first_.size(); ++t) first_[t] += first_[t - 1];
    triangles_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto& chunk : chunks)
        for (const Meeting& m : chunk) triangles_[next[m.tile]++] = m.triangle;
}

}  // namespace zproof
