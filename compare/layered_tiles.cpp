#include "compare/layered_tiles.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "compare/layers.h"
#include "compare/open_tiles.h"

namespace zproof {

namespace {

/// Open pixels of a tile from which on it is worth the trouble to look at whole rows, and of each row that
/// has any.
constexpr std::uint32_t many = 16, many_of_row = 4;

bool is_layered(const OpenTiles::Tile& tile) {
    const auto rows = std::ranges::count_if(tile.rows, [](const OpenTiles::Row& r) { return r.pixels != 0; });
    return tile.count >= many && tile.count >= many_of_row * std::uint32_t(rows);
}

/// How far triangles are looked for around a pixel. Squares that are larger are left.
constexpr double reach_px = 1;

struct LawOfBoth {
    DepthLaw candidate, reference;
};

/// What one thread remembers.
struct Memories {
    explicit Memories(const Comparands& of) : acquaintance(of.scene, of.view) {}

    Acquaintance acquaintance;
    CoplanarMemory coplanar{4096};
    Memory<std::uint32_t, LawOfBoth> laws{1024};
};

/// One renderer's row of a tile.
struct Shown {
    TileRowOf<PrimitiveId> primitive;
    TileRowOf<float> camera_depth;

    Shown(const Frame& frame, const RowPlace& at) {
        take(frame.primitive.row(at.y), at.left, PrimitiveId::none, primitive);
        take(frame.camera_depth.row(at.y), at.left, background_depth, camera_depth);
    }

  private:
    /// Beyond the image nothing shows.
    template <class T>
    static void take(std::span<const T> row, int left, T beyond, TileRowOf<T>& taken) {
        const std::span<const T> rest = row.subspan(std::size_t(left));
        if (rest.size() >= tile_columns) {
            std::copy_n(rest.begin(), tile_columns, taken.begin());
        } else {
            taken.fill(beyond);
            std::ranges::copy(rest, taken.begin());
        }
    }
};

/// What is certain of one renderer's answers along a row.
struct Certain {
    ColumnMask tied = 0, visible = 0;  ///< with a lawful depth
    DepthRow depth;                    ///< there; elsewhere unwritten

    ColumnMask any() const { return tied | visible; }
    void add(const Layers::Standings& standings, const DepthRow& row) {
        const ColumnMask lawful = at_least_zero(row.ratio),
                         here = (standings.tied | standings.visible) & lawful;
        if (any() == 0)
            depth = row;
        else
            depth = {chosen(depth.low, row.low, here), chosen(depth.truth, row.truth, here),
                     chosen(depth.high, row.high, here), chosen(depth.ratio, row.ratio, here)};
        tied |= standings.tied & lawful;
        visible |= standings.visible & lawful;
    }
};

class LayeredPass {
  public:
    LayeredPass(const Comparands& of, std::span<const PixelPlace> open, Verdict& verdict)
        : of_(of), open_(open), verdict_(verdict), sights_(of.view), tiles_(of.view, open), memories_([&] {
              return Memories(of);
          }) {
        farthest_.fill(reach_px);
    }

    LayeredFindings settle() {
        const AskedBoxes asked = asked_boxes();
        if (asked.reach_px() == 0) return all_left();
        const TrianglesByTile near(of_.scene, of_.view, asked);
        std::vector<LayeredFindings> bands(std::size_t(tiles_.tiles().rows));
        tbb::parallel_for(0, tiles_.tiles().rows, [&](int row) {
            for (int column = 0; column < tiles_.tiles().columns; ++column)
                settle_tile(column, row, near, bands[std::size_t(row)]);
            std::ranges::sort(bands[std::size_t(row)].left);
        });
        return sum_of(bands);
    }

  private:
    using Bounds = std::array<const ViewBounds*, 2>;
    Bounds bounds() const { return {&of_.candidate.bounds(), &of_.reference.bounds()}; }

    LayeredFindings all_left() const {
        LayeredFindings all;
        all.left.resize(open_.size());
        for (std::size_t i = 0; i < open_.size(); ++i) all.left[i] = std::uint32_t(i);
        return all;
    }
    static LayeredFindings sum_of(const std::vector<LayeredFindings>& bands) {
        LayeredFindings sum;
        for (const LayeredFindings& band : bands) {
            sum.left.insert(sum.left.end(), band.left.begin(), band.left.end());
            for (std::size_t c = 0; c < band.counts.size(); ++c) sum.counts[c] += band.counts[c];
        }
        return sum;
    }

    /// Of tiles that are worth it.
    AskedBoxes asked_boxes() const {
        const Tiles& tiles = tiles_.tiles();
        AskedBoxes asked(tiles.count());
        for (int row = 0; row < tiles.rows; ++row)
            for (int column = 0; column < tiles.columns; ++column) {
                if (!is_layered(tiles_.at(column, row))) continue;
                Around box = centres(column, row);
                box.half_x += reach_px, box.half_y += reach_px;
                asked.add(tiles.index(column, row), raster_box(box), reach_px);
            }
        return asked;
    }

    RowPlace row_of(int column, int row, std::size_t y) const {
        return {column * Tiles::side_px, row * Tiles::side_px + int(y)};
    }

    /// Of a tile's open pixels.
    Around centres(int column, int row) const {
        ColumnMask any = 0;
        Box box;
        const OpenTiles::Tile& tile = tiles_.at(column, row);
        for (std::size_t y = 0; y < tile.rows.size(); ++y) {
            any |= tile.rows[y].pixels;
            if (tile.rows[y].pixels != 0) box.add(column * Tiles::side_px, row_of(column, row, y).y);
        }
        box.add(column * Tiles::side_px + int(std::bit_width(any)) - 1, box.top);
        return {box.middle_x(), box.middle_y(), 0.5 * (box.right - box.left), 0.5 * (box.bottom - box.top)};
    }

    void settle_tile(int column, int row, const TrianglesByTile& near, LayeredFindings& found) {
        const OpenTiles::Tile& tile = tiles_.at(column, row);
        if (tile.count == 0) return;
        Memories& memories = memories_.local();
        std::optional<Layers> layers;
        if (is_layered(tile))
            layers.emplace(Layers::Shared{sights_, memories.acquaintance, memories.coplanar},
                           centres(column, row), near.of(tiles_.tiles().index(column, row)), bounds());
        for (std::size_t y = 0; y < tile.rows.size(); ++y) {
            const OpenTiles::Row& pixels = tile.rows[y];
            if (pixels.pixels == 0) continue;
            ColumnMask settled = 0;
            if (layers && layers->are_known())
                settled = settle_row(*layers, row_of(column, row, y), pixels, found.counts);
            std::uint32_t place = pixels.first;
            for (ColumnMask rest = pixels.pixels; rest != 0; rest &= rest - 1, ++place)
                if ((settled & -rest & rest) == 0) found.left.push_back(place);
        }
    }

    /// Writes what is certain.
    ColumnMask settle_row(Layers& layers, const RowPlace& at, const OpenTiles::Row& row,
                          ClassCounts& counts) {
        const Shown ours(of_.candidate.frame(), at), theirs(of_.reference.frame(), at);
        ColumnMask open = layers.turn_to(at.y, row.pixels & ~equal(ours.primitive, theirs.primitive));
        if (open == 0) return 0;
        for (std::size_t renderer = 0; renderer < 2; ++renderer)
            open &= ~above(layers.eps_px(renderer), farthest_);
        const Certain candidate = certain(layers, 0, at, ours, open);
        const Certain reference = certain(layers, 1, at, theirs, candidate.any());
        const ColumnMask settled = reference.any();
        std::uint32_t place = row.first;
        for (ColumnMask rest = row.pixels; rest != 0; rest &= rest - 1, ++place) {
            const auto i = std::size_t(std::countr_zero(rest));
            if ((settled >> i & 1) == 0) continue;
            const bool is_tied = ((candidate.tied | reference.tied) >> i & 1) != 0;
            const PixelClass verdict =
                class_of(is_tied ? Standing::tied : Standing::visible, Standing::visible);
            ++counts[std::size_t(verdict)];
            verdict_.classes.at(at.left + int(i), at.y) = verdict;
            verdict_.findings[place] = {.x = at.left + int(i),
                                        .y = at.y,
                                        .verdict = verdict,
                                        .candidate = {ours.primitive[i], ours.camera_depth[i]},
                                        .reference = {theirs.primitive[i], theirs.camera_depth[i]},
                                        .eps_px = layers.eps_px(0)[i],
                                        .candidate_depth = {candidate.depth.low[i], candidate.depth.truth[i],
                                                            candidate.depth.high[i]},
                                        .error_over_bound = candidate.depth.ratio[i]};
        }
        return settled;
    }

    Certain certain(Layers& layers, std::size_t renderer, const RowPlace& at, const Shown& shown,
                    ColumnMask open) {
        Certain all;
        for (ColumnMask rest = open; rest != 0;) {
            const PrimitiveId one = shown.primitive[std::size_t(std::countr_zero(rest))];
            const ColumnMask pixels = rest & equal(shown.primitive, one);
            rest &= ~pixels;
            const auto standings = layers.standings(renderer, std::uint32_t(one), pixels);
            if ((standings.tied | standings.visible) == 0) continue;
            const LawOfBoth& law = law_of(one);
            all.add(standings, depths_in_row(renderer == 0 ? law.candidate : law.reference,
                                             of_.candidate.projection(), at, shown.camera_depth));
        }
        return all;
    }

    const LawOfBoth& law_of(PrimitiveId primitive) {
        return memories_.local().laws(std::uint32_t(primitive), [&] {
            const TriangleInView triangle = of_.candidate.triangle_in_view(primitive);
            return LawOfBoth{depth_law_of(triangle, of_.candidate.bounds()),
                             depth_law_of(triangle, of_.reference.bounds())};
        });
    }

    const Comparands& of_;
    std::span<const PixelPlace> open_;
    Verdict& verdict_;
    Sights<double> sights_;
    OpenTiles tiles_;
    tbb::enumerable_thread_specific<Memories> memories_;
    TileRow farthest_;  ///< reach_px
};

}  // namespace

LayeredFindings settle_layers(const Comparands& of, std::span<const PixelPlace> open, Verdict& verdict) {
    return LayeredPass(of, open, verdict).settle();
}

}  // namespace zproof
