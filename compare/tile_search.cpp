#include "compare/tile_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "compare/neighbourhood.h"
#include "compare/triangle_filter.h"

namespace zproof {

namespace {

/// Triangles that are searched together: long runs share more of their corners, short ones more threads.
std::size_t chunk_triangles(std::size_t count) { return std::clamp<std::size_t>(count / 64, 4096, 32768); }

/// A box in float32, rounded outwards, far sides negated, so that the box of several is their minimum.
struct Outset {
    std::array<float, 4> least;  ///< left, top, -right, -bottom

    static Outset around(const Box& box) {
        return {{down(box.left), down(box.top), down(-box.right), down(-box.bottom)}};
    }
    /// Of what cannot be told; the box of anything with it cannot be told either.
    static Outset unknown() {
        constexpr float everywhere = -std::numeric_limits<float>::infinity();
        return {{everywhere, everywhere, everywhere, everywhere}};
    }
    bool is_unknown() const { return std::isinf(least[0]); }
    static Outset of(const Outset& a, const Outset& b, const Outset& c) {
        Outset all = a;
        for (std::size_t i = 0; i < 4; ++i) {
            const float with_b = b.least[i] < all.least[i] ? b.least[i] : all.least[i];
            all.least[i] = c.least[i] < with_b ? c.least[i] : with_b;
        }
        return all;
    }
    Box box() const { return {least[0], least[1], -least[2], -least[3]}; }

  private:
    /// At or below: rounding to float32 is within 2^-24 of the value.
    static float down(double value) { return float(value - std::abs(value) * 0x1p-23); }
};

/// How many tiles before a place, row by row, are asked about: any in a rectangle by four look-ups.
class AskedTiles {
  public:
    AskedTiles(const Tiles& tiles, const AskedBoxes& asked)
        : width_(std::size_t(tiles.columns) + 1), sums_(width_ * (std::size_t(tiles.rows) + 1)) {
        for (int row = 0; row < tiles.rows; ++row)
            for (int column = 0; column < tiles.columns; ++column)
                at(column + 1, row + 1) = at(column, row + 1) + at(column + 1, row) - at(column, row) +
                                          !asked.of(tiles.index(column, row)).empty();
    }
    /// Both ends included.
    bool any(int left, int top, int right, int bottom) const {
        return at(right + 1, bottom + 1) - at(left, bottom + 1) - at(right + 1, top) + at(left, top) != 0;
    }

  private:
    std::uint32_t& at(int column, int row) { return sums_[std::size_t(row) * width_ + std::size_t(column)]; }
    std::uint32_t at(int column, int row) const {
        return sums_[std::size_t(row) * width_ + std::size_t(column)];
    }

    std::size_t width_;
    std::vector<std::uint32_t> sums_;
};

/// The corners of a run of triangles, each projected once where the run's indices lie close together, as they
/// do in most meshes. Only the run's are kept: those of a whole scene would need as much memory as the scene.
class RunCorners {
  public:
    RunCorners(const Scene& scene, const BoxProjection& projection, std::span<const glm::uvec3> run)
        : scene_(scene), projection_(projection) {
        std::uint32_t first = UINT32_MAX, last = 0;
        for (const glm::uvec3& t : run) {
            first = std::min({first, t.x, t.y, t.z});
            last = std::max({last, t.x, t.y, t.z});
        }
        if (last - first >= most_corners_each * run.size()) return;
        first_ = first;
        outsets_.reserve(std::size_t{last} - first + 1);
        for (std::size_t i = first; i <= last; ++i) outsets_.push_back(projected(i));
    }

    Outset operator[](std::uint32_t vertex) const {
        return outsets_.empty() ? projected(vertex) : outsets_[vertex - first_];
    }

  private:
    static constexpr std::size_t most_corners_each = 3;  ///< a soup has as many

    Outset projected(std::size_t vertex) const {
        const auto box = projection_(scene_.vertices.position_world[vertex]);
        return box ? Outset::around(*box) : Outset::unknown();
    }

    const Scene& scene_;
    const BoxProjection& projection_;
    std::uint32_t first_ = 0;
    std::vector<Outset> outsets_;
};

struct Meeting {
    std::uint32_t tile, triangle;
};

/// Finds the tiles that one triangle meets. Its edges are asked only where its box does not say no.
class TileSearch {
  public:
    TileSearch(const Scene& scene, const View& view, const AskedBoxes& asked)
        : scene_(scene),
          asked_(asked),
          reach_px_(asked.reach_px()),
          tiles_(view),
          asked_tiles_(tiles_, asked),
          projection_(view),
          filters_(view) {}

    /// Triangles from first to before end, ascending.
    void search(std::size_t first, std::size_t end, std::vector<Meeting>& found) const {
        const RunCorners corners(scene_, projection_,
                                 std::span(scene_.triangles).subspan(first, end - first));
        for (std::size_t t = first; t < end; ++t) search(std::uint32_t(t), corners, found);
    }

  private:
    void search(std::uint32_t triangle, const RunCorners& corners, std::vector<Meeting>& found) const {
        const glm::uvec3 v = scene_.triangles[triangle];
        const Outset all = Outset::of(corners[v.x], corners[v.y], corners[v.z]);
        if (!all.is_unknown())
            search(triangle, all.box(), found);
        else if (const auto box = projection_(corners_of(scene_, triangle)))
            search(triangle, *box, found);
    }

    void search(std::uint32_t triangle, const Box& box, std::vector<Meeting>& found) const {
        const double reach = reach_px_;
        const int left = clamped(box.left - reach, tiles_.columns),
                  right = clamped(box.right + reach, tiles_.columns);
        const int top = clamped(box.top - reach, tiles_.rows),
                  bottom = clamped(box.bottom + reach, tiles_.rows);
        if (!asked_tiles_.any(left, top, right, bottom)) return;
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
    AskedTiles asked_tiles_;
    BoxProjection projection_;
    TriangleFilters filters_;
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
    const std::size_t length = chunk_triangles(count);
    std::vector<std::vector<Meeting>> chunks((count + length - 1) / length);
    tbb::parallel_for(std::size_t(0), chunks.size(), [&](std::size_t chunk) {
        const std::size_t first = chunk * length;
        tile_search.search(first, std::min(count, first + length), chunks[chunk]);
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
