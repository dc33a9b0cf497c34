#include "compare/search/tile_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "compare/search/asked_cells.h"
#include "compare/search/corner_hull.h"
#include "compare/search/run_corners.h"
#include "compare/search/triangle_filter.h"
#include "compare/truth/neighbourhood.h"
#include "math/bulk.h"

namespace zproof {

namespace {

/// Triangles that are searched together: long runs share more of their corners, short ones more threads.
std::size_t chunk_triangles(std::size_t count) { return std::clamp<std::size_t>(count / 64, 64, 32768); }

/// From so many triangles on, and so many for each tile, it is worth it to mark the cells that are asked
/// about.
constexpr std::size_t cells_from_triangles = 8192, cells_from_triangles_of_tile = 8;

/// Triangles that are asked about together.
constexpr std::size_t neighbours = 8;

struct Meeting {
    std::uint32_t tile, triangle;
};

/// Finds the tiles that one triangle meets. Its edges are asked only where its box does not say no.
class TileSearch {
  public:
    TileSearch(const Scene& scene, const View& view, const AskedTiles& asked)
        : scene_(scene),
          reach_px_(float(asked.reach_px()) + rounding_px),
          tiles_(view),
          asked_(asked),
          projection_(view),
          filters_(view) {
        if (scene.triangles.size() >=
            std::max(cells_from_triangles, cells_from_triangles_of_tile * asked.all().size()))
            asked_cells_.emplace(view, asked);
    }

    /// Triangles from first to before end, ascending. Neighbours in a mesh lie close together: most are far
    /// from all that is asked about, and so are those around them.
    void search(std::size_t first, std::size_t end, Bulk<Meeting>& found) const {
        const std::span run = std::span(scene_.triangles).subspan(first, end - first);
        const RunCorners corners(scene_.vertices.position_world, FloatProjection(projection_), run);
        for (std::size_t i = 0; i < run.size(); i += neighbours) {
            const std::size_t last = std::min(run.size(), i + neighbours);
            std::array<FloatBox, neighbours> boxes;
            FloatBox all;
            for (std::size_t k = i; k < last; ++k) all.add(boxes[k - i] = corners.of(k, run[k]).all());
            if (!may_hold_any(all)) continue;
            for (std::size_t k = i; k < last; ++k)
                if (may_hold_any(boxes[k - i]))
                    search(std::uint32_t(first + k), corners.of(k, run[k]), found);
        }
    }

  private:
    bool may_hold_any(const FloatBox& box) const { return !asked_cells_ || asked_cells_->any(box); }
    void search(std::uint32_t triangle, const FloatCorners& corners, Bulk<Meeting>& found) const {
        const FloatBox box = corners.all();
        if (box.is_everywhere()) return search_clipped(triangle, found);
        bool is_drawn = false;
        CornerHull hull;
        search(triangle, box, found, [&](const FloatBox& asked) {
            if (!is_drawn) draw(hull, triangle, corners);
            is_drawn = true;
            return !hull.is_beside(asked.in_double());
        });
    }
    /// Large ones may have corners far outside the image, which a float places too coarsely.
    void draw(CornerHull& hull, std::uint32_t triangle, const FloatCorners& corners) const {
        if (!corners.all().fits(Tiles::side_px))
            if (const auto precise = projection_.of_corners(corners_of(scene_, triangle)))
                return hull.draw(*precise);
        const CornerBoxes boxes = corners.in_double();
        hull.draw(boxes);
    }
    /// One with a corner that has no place: it reaches behind half the near depth.
    void search_clipped(std::uint32_t triangle, Bulk<Meeting>& found) const {
        const CornersWorld p_world = corners_of(scene_, triangle);
        const auto box = projection_(p_world);
        if (!box) return;
        const TriangleFilter filter = filters_.of(p_world);
        search(triangle, FloatBox::holding(*box), found, [&](const FloatBox& asked) {
            constexpr float last = std::numeric_limits<float>::max();  // beyond there is no middle
            return !asked.fits(last) || !filter.misses(around(asked.in_double()));
        });
    }
    /// may_meet(asked): of boxes that meet its own.
    template <class MayMeet>
    void search(std::uint32_t triangle, const FloatBox& box, Bulk<Meeting>& found,
                const MayMeet& may_meet) const {
        const int left = clamped(box.left() - reach_px_, tiles_.columns),
                  right = clamped(box.right() + reach_px_, tiles_.columns);
        const int top = clamped(box.top() - reach_px_, tiles_.rows),
                  bottom = clamped(box.bottom() + reach_px_, tiles_.rows);
        const auto meets = [&](const FloatBox& asked) { return box.meets(asked) && may_meet(asked); };
        for (int row = top; row <= bottom; ++row)
            for (const AskedTiles::Tile& tile : asked_.of(row, left, right))
                if (box.meets(tile.all) && (tile.boxes.size() == 1 || may_meet(tile.all)) &&
                    std::ranges::any_of(tile.boxes, meets))
                    found.push_back({tile.index, triangle});
    }
    /// More than places of an image, of up to 2^15 px, are rounded by.
    static constexpr float rounding_px = 1.0F / 16;
    static int clamped(float px, int count) {
        return int(std::clamp(px / Tiles::side_px, 0.0F, float(count - 1)));
    }

    const Scene& scene_;
    float reach_px_;
    Tiles tiles_;
    const AskedTiles& asked_;
    std::optional<AskedCells> asked_cells_;
    BoxProjection projection_;
    TriangleFilters filters_;
};

}  // namespace

TrianglesByTile::TrianglesByTile(const Scene& scene, const View& view, const AskedTiles& asked)
    : first_(Tiles(view).count() + 2) {
    const TileSearch tile_search(scene, view, asked);
    const std::size_t count = scene.triangles.size();
    const std::size_t length = chunk_triangles(count);
    std::vector<Bulk<Meeting>> chunks((count + length - 1) / length);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t chunk) {
        const std::size_t first = chunk * length;
        tile_search.search(first, std::min(count, first + length), chunks[chunk]);
    });
    // counted two places ahead, so that filling leaves each tile's end where the next one's first belongs
    for (const auto& chunk : chunks)
        for (const Meeting& m : chunk) ++first_[m.tile + 2];
    for (std::size_t t = 2; t < first_.size(); ++t) first_[t] += first_[t - 1];
    triangles_.resize(first_.back());
    for (const auto& chunk : chunks)
        for (const Meeting& m : chunk) triangles_[first_[m.tile + 1]++] = m.triangle;
    first_.pop_back();
}

}  // namespace zproof
