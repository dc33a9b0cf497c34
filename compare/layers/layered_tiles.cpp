#include "compare/layers/layered_tiles.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

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

/// A tile with open pixels, as both show it.
struct LayeredTile {
    TilePlace place;
    const OpenTiles::Tile& opened;
    ShownTile ours, theirs;

    LayeredTile(const Comparands& of, const OpenTiles::Tile& tile, const TilePlace& at)
        : place(at),
          opened(tile),
          ours(of.candidate.frame(), at, tile.differ),
          theirs(of.reference.frame(), at, tile.differ) {}
};

/// Pixels at which one renderer's, or both's, answers are tied, and visible.
using Standings = Layers::Standings;

class LayeredPass {
  public:
    LayeredPass(const Comparands& of, OpenTiles& open, ClassMap& classes, std::span<Finding> findings)
        : of_(of),
          open_(open),
          classes_(classes),
          findings_(findings),
          choice_(choose_layered_tiles(of, open, reach_px)),
          memories_([&] { return Memories(of); }) {}

    ClassCounts settle() {
        const Tiles& tiles = open_.tiles();
        ClassCounts sum{};
        if (choice_.asked.all().empty()) return sum;
        const TrianglesByTile near(of_.scene, of_.view, choice_.asked);
        std::vector<ClassCounts> counts(std::size_t(tiles.rows));
        tbb::parallel_for(0, tiles.rows, [&](int row) {
            ClassCounts of_row{};
            const std::span<OpenTiles::Tile> band = open_.of_row(row);
            for (std::size_t i = 0; i < band.size(); ++i) {
                if (i + 1 < band.size()) fetch(band[i + 1], row);
                settle_tile(band[i], row, near, of_row);
            }
            counts[std::size_t(row)] = of_row;
        });
        for (const ClassCounts& some : counts)
            for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += some[c];
        return sum;
    }

  private:
    using Bounds = std::array<const ViewBounds*, 2>;
    Bounds bounds() const { return {&of_.candidate.bounds(), &of_.reference.bounds()}; }

    static TilePlace place_of(int column, int row) { return {column * Tiles::side_px, row * Tiles::side_px}; }

    /// Asks for what both show in a tile that comes next.
    void fetch(const OpenTiles::Tile& tile, int row) const {
        const TilePlace at = place_of(tile.column, row);
        for (const Frame* const frame : {&of_.candidate.frame(), &of_.reference.frame()})
            for (int y = 0; y < TileMask::rows && at.top + y < frame->size().height; ++y)
                __builtin_prefetch(&frame->primitive.row(at.top + y)[std::size_t(at.left)]);
    }

    /// Writes what is certain, and leaves the rest.
    void settle_tile(OpenTiles::Tile& open, int row, const TrianglesByTile& near, ClassCounts& counts) {
        const std::size_t index = open_.tiles().index(open.column, row);
        if (!choice_.asked.has(open.column, row) || !is_worth_layers(open, near.of(index).size())) return;
        Memories& memories = memories_.local();
        memories.acquaintance.forget_if_much();
        Layers& layers = memories.layers;
        const TilePlace place = place_of(open.column, row);
        layers.turn_to(place, choice_.centres[index], near.of(index), bounds());
        if (!layers.are_known() || layers.widest_px() > reach_px) return;
        const LayeredTile tile(of_, open, place);
        const TileMask settled = settle(layers, tile, counts);
        open.left &= ~settled;
        if (!findings_.empty())
            for_each_row(settled, [&](int y, ColumnMask columns) { list(layers, tile, y, columns); });
    }

    TileMask settle(Layers& layers, const LayeredTile& tile, ClassCounts& counts) {
        const TileMask open = layers.uncut(tile.opened.differ);
        const Standings candidate = standings(layers, 0, tile.ours, open);
        const Standings reference = standings(layers, 1, tile.theirs, candidate.tied | candidate.visible);
        const TileMask settled = lawful(tile, reference.tied | reference.visible);
        const TileMask tied = settled & (candidate.tied | reference.tied);
        write(class_of(Standing::tied, Standing::visible), tile.place, tied, counts);
        write(class_of(Standing::visible, Standing::visible), tile.place, settled & ~tied, counts);
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
        TileMask found = pixels & tile.opened.lawful;
        for_each_row(pixels & ~found, [&](int y, ColumnMask columns) {
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
                findings_[number_in(tile.opened, int(i), y)] = {
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
        ClassMap::Tile& tile = classes_.tile_at(at.left / Tiles::side_px, at.top / Tiles::side_px);
        for_each_row(pixels, [&](int y, ColumnMask columns) {
            put_where(columns, verdict, &tile[std::size_t(y) * Tiles::side_px]);
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
    OpenTiles& open_;
    ClassMap& classes_;
    std::span<Finding> findings_;
    LayeredChoice choice_;
    tbb::enumerable_thread_specific<Memories> memories_;
};

}  // namespace

ClassCounts settle_layers(const Comparands& of, OpenTiles& open, ClassMap& classes,
                          std::span<Finding> findings) {
    return LayeredPass(of, open, classes, findings).settle();
}

}  // namespace zproof
