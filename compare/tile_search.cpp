#include "compare/tile_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "compare/corner_cells.h"
#include "compare/corner_hull.h"
#include "compare/neighbourhood.h"
#include "compare/triangle_filter.h"

namespace zproof {

namespace {

/// Triangles that are searched together: long runs share more of their corners, short ones more threads.
std::size_t chunk_triangles(std::size_t count) { return std::clamp<std::size_t>(count / 64, 64, 32768); }

/// How many cells above and left of a place hold anything that is asked about, modulo 2^16: any in a
/// rectangle by four look-ups, where it has fewer cells than that.
class AskedCells {
  public:
    AskedCells(const Cells& cells, const AskedTiles& asked)
        : width_(std::size_t(cells.columns) + 1), sums_(width_ * (std::size_t(cells.rows) + 1)) {
        std::vector<bool> is_marked(std::size_t(cells.rows));
        for (const AskedTiles::Tile& tile : asked.all())
            for (const Box& box : tile.boxes) mark(cells, box, is_marked);
        for (int row = 0; row < cells.rows; ++row) {
            if (is_marked[std::size_t(row)])
                sum_up(row, cells.columns);
            else
                std::copy_n(&at(0, row), width_, &at(0, row + 1));
        }
    }
    /// Both ends included. A rectangle of 2^16 cells and more is taken to hold some.
    bool any(const CellReach& in) const {
        const int left = in.left(), top = in.top(), right = in.right(), bottom = in.bottom();
        const int cells = (right - left + 1) * (bottom - top + 1);
        const int sum = at(right + 1, bottom + 1) - at(left, bottom + 1) - at(right + 1, top) + at(left, top);
        return Sum(sum) != 0 || cells > int{std::numeric_limits<Sum>::max()};
    }

  private:
    using Sum = std::uint16_t;

    void mark(const Cells& cells, const Box& box, std::vector<bool>& is_marked) {
        const int right = cells.column_of(box.right), bottom = cells.row_of(box.bottom);
        for (int row = cells.row_of(box.top); row <= bottom; ++row) {
            is_marked[std::size_t(row)] = true;
            for (int column = cells.column_of(box.left); column <= right; ++column)
                at(column + 1, row + 1) = 1;
        }
    }
    void sum_up(int row, int columns) {
        Sum of_row = 0;
        for (int column = 1; column <= columns; ++column) {
            of_row = Sum(of_row + at(column, row + 1));
            at(column, row + 1) = Sum(at(column, row) + of_row);
        }
    }
    Sum& at(int column, int row) { return sums_[std::size_t(row) * width_ + std::size_t(column)]; }
    Sum at(int column, int row) const { return sums_[std::size_t(row) * width_ + std::size_t(column)]; }

    std::size_t width_;
    std::vector<Sum> sums_;
};

struct IndexRange {
    std::uint32_t first, last;
};
static_assert(sizeof(glm::uvec3) == 3 * sizeof(std::uint32_t));
/// Of the corners of at least one triangle. Compilers make vectors of it.
[[gnu::target_clones("default", "avx2")]] IndexRange index_range(std::span<const glm::uvec3> run) {
    const std::uint32_t* const index = &run[0].x;
    std::uint32_t first = index[0], last = index[0];
    for (std::size_t i = 0; i < 3 * run.size(); ++i) {
        first = index[i] < first ? index[i] : first;
        last = index[i] > last ? index[i] : last;
    }
    return {first, last};
}

/// The cells of the corners of a run of triangles, each found once where the run's indices lie close
/// together, as they do in most meshes, and otherwise once for every triangle. Only the run's are kept: those
/// of a whole scene would take a quarter of the scene's own memory.
class RunCorners {
  public:
    RunCorners(std::span<const glm::vec3> p_world, const CornerCells& cells,
               std::span<const glm::uvec3> run) {
        const auto [first, last] = index_range(run);
        is_shared_ = last - first < 3 * run.size();
        first_ = first;
        std::vector<glm::vec3> apart;
        if (!is_shared_)
            for (const glm::uvec3& t : run)
                apart.insert(apart.end(), {p_world[t.x], p_world[t.y], p_world[t.z]});
        const auto corners = is_shared_ ? p_world.subspan(first, std::size_t{last} - first + 1) : apart;
        reach_.resize(corners.size());
        cells.find(corners, reach_);
    }

    /// Of triangle i of the run, which has these corners.
    CellReach of(std::size_t i, const glm::uvec3& t) const {
        const glm::uvec3 at = is_shared_ ? t - first_ : std::uint32_t(3 * i) + glm::uvec3(0, 1, 2);
        return CellReach::of(reach_[at.x], reach_[at.y], reach_[at.z]);
    }

  private:
    bool is_shared_ = false;
    std::uint32_t first_ = 0;
    std::vector<CellReach> reach_;
};

/// Triangles that are asked about together.
constexpr std::size_t neighbours = 8;

struct Meeting {
    std::uint32_t tile, triangle;
};

CellReach around_all(std::span<const CellReach> reach) {
    CellReach all = reach[0];
    for (const CellReach& one : reach.subspan(1)) all.add(one);
    return all;
}

/// Finds the tiles that one triangle meets. Its box is asked only where its corners' cells do not say no, and
/// its edges only where its box does not.
class TileSearch {
  public:
    TileSearch(const Scene& scene, const View& view, const AskedBoxes& asked)
        : scene_(scene),
          reach_px_(asked.reach_px()),
          tiles_(view),
          asked_(tiles_, asked),
          cells_(view),
          asked_cells_(cells_, asked_),
          projection_(view),
          corner_cells_(projection_, cells_),
          filters_(view) {}

    /// Triangles from first to before end, ascending. Neighbours in a mesh lie close together: most are far
    /// from all that is asked about, and so are those around them.
    void search(std::size_t first, std::size_t end, std::vector<Meeting>& found) const {
        const std::span run = std::span(scene_.triangles).subspan(first, end - first);
        const RunCorners corners(scene_.vertices.position_world, corner_cells_, run);
        std::array<CellReach, neighbours> reach;
        for (std::size_t i = 0; i < run.size(); i += neighbours) {
            const std::size_t some = std::min(run.size() - i, neighbours);
            for (std::size_t k = 0; k < some; ++k) reach[k] = corners.of(i + k, run[i + k]);
            if (!asked_cells_.any(around_all(std::span(reach).first(some)))) continue;
            for (std::size_t k = 0; k < some; ++k)
                if (asked_cells_.any(reach[k])) search(std::uint32_t(first + i + k), found);
        }
    }

  private:
    void search(std::uint32_t triangle, std::vector<Meeting>& found) const {
        const CornersWorld p_world = corners_of(scene_, triangle);
        if (const auto corners = projection_.of_corners(p_world)) {
            const Box box = corners->all();
            if (box.fits(Tiles::side_px)) {
                search(triangle, box, found, [](const Box&) { return true; });
            } else {
                std::optional<CornerHull> hull;
                search(triangle, box, found, [&](const Box& asked) {
                    if (!hull) hull.emplace(*corners);
                    return !hull->is_beside(asked);
                });
            }
        } else if (const auto box = projection_(p_world)) {
            const TriangleFilter filter = filters_.of(p_world);
            search(triangle, *box, found, [&](const Box& asked) { return !filter.misses(around(asked)); });
        }
    }
    /// may_meet(asked): of boxes that meet its own.
    template <class MayMeet>
    void search(std::uint32_t triangle, const Box& box, std::vector<Meeting>& found,
                const MayMeet& may_meet) const {
        const double reach = reach_px_;
        const int left = clamped(box.left - reach, tiles_.columns),
                  right = clamped(box.right + reach, tiles_.columns);
        const int top = clamped(box.top - reach, tiles_.rows),
                  bottom = clamped(box.bottom + reach, tiles_.rows);
        const auto meets = [&](const Box& asked) { return box.meets(asked) && may_meet(asked); };
        for (int row = top; row <= bottom; ++row)
            for (const AskedTiles::Tile& tile : asked_.of(row, left, right))
                if (meets(tile.all) && std::ranges::any_of(tile.boxes, meets))
                    found.push_back({tile.index, triangle});
    }
    static int clamped(double px, int count) {
        return int(std::clamp(px / Tiles::side_px, 0.0, count - 1.0));
    }

    const Scene& scene_;
    double reach_px_;
    Tiles tiles_;
    AskedTiles asked_;
    Cells cells_;
    AskedCells asked_cells_;
    BoxProjection projection_;
    CornerCells corner_cells_;
    TriangleFilters filters_;
};

}  // namespace

TrianglesByTile::TrianglesByTile(const Scene& scene, const View& view, const AskedBoxes& asked)
    : first_(Tiles(view).count() + 2) {
    const TileSearch tile_search(scene, view, asked);
    const std::size_t count = scene.triangles.size();
    const std::size_t length = chunk_triangles(count);
    std::vector<std::vector<Meeting>> chunks((count + length - 1) / length);
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
