#include "compare/layers/layered_tiles.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "compare/first_pass/held_depths.h"
#include "compare/layers/layered_choice.h"
#include "compare/layers/layers.h"
#include "compare/layers/shown_tile.h"
#include "compare/search/tile_search.h"

namespace zproof {

namespace {

/// How far triangles are looked for around a pixel. Squares that are larger are left.
constexpr double reach_px = 1;

/// What both renderers may say of a triangle's depth.
struct LawOfBoth {
    DepthLaw candidate, reference;
};

/// What one thread remembers.
struct Memories {
    explicit Memories(const Comparands& of)
        : sights(of.view), acquaintance(of.scene, of.view), layers({sights, acquaintance, coplanar}) {}
    Memories(const Memories&) = delete;  // layers look at the rest
    Memories& operator=(const Memories&) = delete;

    Sights<double> sights;
    Acquaintance acquaintance;
    CoplanarMemory coplanar{4096};
    Layers layers;
    Memory<std::uint32_t, LawOfBoth> laws{1024};
};

using OpenRows = std::span<const OpenTiles::Row>;

TileMask pixels_of(OpenRows rows, ColumnMask OpenTiles::Row::*columns) {
    TileMask pixels;
    for (int y = 0; y < TileMask::rows; ++y) pixels.add(y, rows[std::size_t(y)].*columns);
    return pixels;
}

/// A tile with open pixels, as both show it.
struct LayeredTile {
    TilePlace place;
    OpenRows rows;
    TileMask open, lawful;  ///< lawful: the depths of both are so for certain
    ShownTile ours, theirs;

    LayeredTile(const Comparands& of, const OpenTiles& tiles, const TilePlace& at)
        : place(at),
          rows(tiles.rows_of(at.left / Tiles::side_px, at.top / Tiles::side_px)),
          open(pixels_of(rows, &OpenTiles::Row::pixels)),
          lawful(pixels_of(rows, &OpenTiles::Row::lawful)),
          ours(of.candidate.frame(), at, open),
          theirs(of.reference.frame(), at, open) {}

    /// Of an open pixel, among all that are open.
    std::uint32_t number_of(int y, int column) const {
        const auto& [pixels, lawful_ones, first] = rows[std::size_t(y)];
        return first + std::uint32_t(std::popcount(pixels & ((ColumnMask{1} << column) - 1)));
    }
};

/// Pixels at which one renderer's, or both's, answers are tied, and visible.
using Standings = Layers::Standings;

class LayeredPass {
  public:
    LayeredPass(const Comparands& of, const OpenTiles& open, ClassMap& classes, std::span<Finding> findings)
        : of_(of),
          open_(open),
          classes_(classes),
          findings_(findings),
          choice_(choose_layered_tiles(of, open, reach_px)),
          memories_([&] { return Memories(of); }) {}

    LayeredFindings settle() {
        const Tiles& tiles = open_.tiles();
        if (choice_.asked.all().empty()) return all_left();
        const TrianglesByTile near(of_.scene, of_.view, choice_.asked);
        std::vector<LayeredFindings> bands(std::size_t(tiles.rows));
        tbb::parallel_for(0, tiles.rows, [&](int row) {
            Band band;
            for (int column = 0; column < tiles.columns; ++column) settle_tile(column, row, near, band);
            bands[std::size_t(row)] = in_raster_order(band);
        });
        return sum_of(bands);
    }

  private:
    using Bounds = std::array<const ViewBounds*, 2>;
    Bounds bounds() const { return {&of_.candidate.bounds(), &of_.reference.bounds()}; }

    LayeredFindings all_left() const {
        LayeredFindings all;
        all.left = open_.places();
        all.places.resize(all.left.size());
        std::iota(all.places.begin(), all.places.end(), std::uint32_t(0));
        return all;
    }

    /// A row of tiles.
    struct Band {
        struct Left {
            PixelPlace at;
            std::uint32_t place;
        };
        std::vector<Left> left;
        ClassCounts counts{};
    };
    static LayeredFindings in_raster_order(Band& band) {
        std::ranges::sort(band.left, {}, &Band::Left::place);
        LayeredFindings found;
        for (const Band::Left& pixel : band.left) {
            found.left.push_back(pixel.at);
            found.places.push_back(pixel.place);
        }
        found.counts = band.counts;
        return found;
    }
    static LayeredFindings sum_of(const std::vector<LayeredFindings>& bands) {
        LayeredFindings sum;
        for (const LayeredFindings& band : bands) {
            sum.left.insert(sum.left.end(), band.left.begin(), band.left.end());
            sum.places.insert(sum.places.end(), band.places.begin(), band.places.end());
            for (std::size_t c = 0; c < band.counts.size(); ++c) sum.counts[c] += band.counts[c];
        }
        return sum;
    }

    static TilePlace place_of(int column, int row) { return {column * Tiles::side_px, row * Tiles::side_px}; }

    /// Asks for what both show in a tile that comes next.
    void fetch(int column, int row) const {
        if (column >= open_.tiles().columns || open_.count(column, row) == 0) return;
        const TilePlace at = place_of(column, row);
        for (const Frame* const frame : {&of_.candidate.frame(), &of_.reference.frame()})
            for (int y = 0; y < TileMask::rows && at.top + y < frame->size().height; ++y)
                __builtin_prefetch(&frame->primitive.row(at.top + y)[std::size_t(at.left)]);
    }

    void settle_tile(int column, int row, const TrianglesByTile& near, Band& band) {
        if (open_.count(column, row) == 0) return;
        fetch(column + 1, row);
        const LayeredTile tile(of_, open_, place_of(column, row));
        const TileMask settled =
            is_worth_it(column, row, near) ? settle(column, row, near, tile, band.counts) : TileMask{};
        for_each_row(tile.open & ~settled, [&](int y, ColumnMask rest) {
            for (; rest != 0; rest &= rest - 1) {
                const int x = std::countr_zero(rest);
                band.left.push_back({{tile.place.left + x, tile.place.top + y}, tile.number_of(y, x)});
            }
        });
    }

    bool is_worth_it(int column, int row, const TrianglesByTile& near) const {
        const std::size_t tile = open_.tiles().index(column, row);
        return choice_.asked.has(column, row) &&
               is_worth_layers(open_.count(column, row), near.of(tile).size());
    }

    /// Writes what is certain.
    TileMask settle(int column, int row, const TrianglesByTile& near, const LayeredTile& tile,
                    ClassCounts& counts) {
        Memories& memories = memories_.local();
        memories.acquaintance.forget_if_much();
        Layers& layers = memories.layers;
        const std::size_t index = open_.tiles().index(column, row);
        layers.turn_to(tile.place, choice_.centres[index], near.of(index), bounds());
        if (!layers.are_known() || layers.widest_px() > reach_px) return {};
        const TileMask open = layers.uncut(where_they_differ(tile.ours, tile.theirs, tile.open));
        const Standings candidate = standings(layers, 0, tile.ours, open);
        const Standings reference = standings(layers, 1, tile.theirs, candidate.tied | candidate.visible);
        const TileMask settled = lawful(tile, reference.tied | reference.visible);
        const TileMask tied = settled & (candidate.tied | reference.tied);
        write(class_of(Standing::tied, Standing::visible), tile.place, tied, counts);
        write(class_of(Standing::visible, Standing::visible), tile.place, settled & ~tied, counts);
        if (!findings_.empty())
            for_each_row(settled, [&](int y, ColumnMask columns) { list(layers, tile, y, columns); });
        return settled;
    }

    static Standings standings(Layers& layers, std::size_t renderer, const ShownTile& shown,
                               const TileMask& pixels) {
        Standings all;
        shown.for_each(pixels, [&](PrimitiveId triangle, const TileMask& here) {
            const Standings some = layers.standings(renderer, std::uint32_t(triangle), here);
            all.tied |= some.tied;
            all.visible |= some.visible;
        });
        return all;
    }

    /// Where the depths of both are lawful for certain; the first pass knows most.
    TileMask lawful(const LayeredTile& tile, const TileMask& pixels) {
        TileMask found = pixels & tile.lawful;
        for_each_row(pixels & ~tile.lawful, [&](int y, ColumnMask columns) {
            const RowPlace at = tile.place.row(y);
            columns = lawful_by_laws(&LawOfBoth::candidate, at, row_of(tile.ours, y), columns);
            found.add(y, lawful_by_laws(&LawOfBoth::reference, at, row_of(tile.theirs, y), columns));
        });
        return found;
    }

    /// A row as one renderer shows it.
    struct ShownRow {
        const PrimitiveId* primitive;
        TileRowOf<float> camera_depth;
    };
    static ShownRow row_of(const ShownTile& shown, int y) {
        return {shown.primitive(y), shown.camera_depth(y)};
    }

    ColumnMask lawful_by_laws(DepthLaw LawOfBoth::*law, const RowPlace& at, const ShownRow& shown,
                              ColumnMask pixels) {
        ColumnMask lawful = 0;
        while (pixels != 0) {
            const PrimitiveId triangle = shown.primitive[std::countr_zero(pixels)];
            const ColumnMask here = pixels & where_equal(shown.primitive, triangle);
            pixels &= ~here;
            const DepthRow depth =
                depths_in_row(law_of(triangle).*law, of_.candidate.projection(), at, shown.camera_depth);
            lawful |= here & at_least_zero(depth.ratio);
        }
        return lawful;
    }

    /// Lists the findings of pixels of a row that are settled.
    void list(Layers& layers, const LayeredTile& tile, int y, ColumnMask settled) {
        const RowPlace at = tile.place.row(y);
        const ShownRow ours = row_of(tile.ours, y), theirs = row_of(tile.theirs, y);
        const TileRow eps_px = layers.eps_px(0, y);
        while (settled != 0) {
            const PrimitiveId triangle = ours.primitive[std::countr_zero(settled)];
            ColumnMask here = settled & where_equal(ours.primitive, triangle);
            settled &= ~here;
            const DepthRow depth =
                depths_in_row(law_of(triangle).candidate, of_.candidate.projection(), at, ours.camera_depth);
            for (; here != 0; here &= here - 1) {
                const auto i = std::size_t(std::countr_zero(here));
                findings_[tile.number_of(y, int(i))] = {
                    .x = at.left + int(i),
                    .y = at.y,
                    .verdict = classes_.at(at.left + int(i), at.y),
                    .candidate = {triangle, ours.camera_depth[i]},
                    .reference = {theirs.primitive[i], theirs.camera_depth[i]},
                    .eps_px = eps_px[i],
                    .candidate_depth = {depth.low[i], depth.truth[i], depth.high[i]},
                    .error_over_bound = depth.ratio[i]};
            }
        }
    }

    void write(PixelClass verdict, const TilePlace& at, const TileMask& pixels, ClassCounts& counts) {
        counts[std::size_t(verdict)] += std::uint64_t(pixels.count());
        for_each_row(pixels, [&](int y, ColumnMask columns) {
            put_where(columns, verdict, &classes_.in_open(at.left, at.top + y));
        });
    }

    const LawOfBoth& law_of(PrimitiveId primitive) {
        return memories_.local().laws(std::uint32_t(primitive), [&] {
            const TriangleInView triangle = of_.candidate.triangle_in_view(primitive);
            return LawOfBoth{depth_law_of(triangle, of_.candidate.bounds()),
                             depth_law_of(triangle, of_.reference.bounds())};
        });
    }

    const Comparands& of_;
    const OpenTiles& open_;
    ClassMap& classes_;
    std::span<Finding> findings_;
    LayeredChoice choice_;
    tbb::enumerable_thread_specific<Memories> memories_;
};

}  // namespace

LayeredFindings settle_layers(const Comparands& of, const OpenTiles& open, ClassMap& classes,
                              std::span<Finding> findings) {
    return LayeredPass(of, open, classes, findings).settle();
}

}  // namespace zproof
