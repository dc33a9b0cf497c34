#include "compare/layered_tiles.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "compare/layered_choice.h"
#include "compare/layers.h"
#include "compare/masks.h"

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
    explicit Memories(const Comparands& of) : acquaintance(of.scene, of.view) {}

    Acquaintance acquaintance;
    CoplanarMemory coplanar{4096};
    Memory<std::uint32_t, LawOfBoth> laws{1024};
};

/// A row of a tile; beyond the image is what is given.
template <class T>
TileRowOf<T> taken(const Plane<T>& plane, const RowPlace& at, T beyond) {
    TileRowOf<T> row;
    const std::span<const T> rest = plane.row(at.y).subspan(std::size_t(at.left));
    if (rest.size() >= tile_columns) {
        std::copy_n(rest.begin(), tile_columns, row.begin());
    } else {
        row.fill(beyond);
        std::ranges::copy(rest, row.begin());
    }
    return row;
}

/// One renderer's row of a tile. Few ask for depths.
struct Shown {
    const Frame& frame;
    RowPlace at;
    TileRowOf<PrimitiveId> primitive = taken(frame.primitive, at, PrimitiveId::none);

    TileRowOf<float> camera_depth() const { return taken(frame.camera_depth, at, background_depth); }
};

/// What both show of the same row.
struct ShownByBoth {
    RowPlace at;
    Shown ours, theirs;

    ShownByBoth(const Comparands& of, const RowPlace& row)
        : at(row), ours{of.candidate.frame(), row}, theirs{of.reference.frame(), row} {}
};

/// Has fetched what both show. Inlined, or gcc 12 takes it for a function without effects and leaves it out.
[[gnu::always_inline]] inline void fetch(const Comparands& of, const RowPlace& row) {
    for (const Frame* const frame : {&of.candidate.frame(), &of.reference.frame()})
        __builtin_prefetch(&frame->primitive.row(row.y)[std::size_t(row.left)]);
}

/// Along a row: pixels at which one renderer's, or both's, answers are tied, and visible.
using Standings = Layers::Standings;

/// Answers of triangles that the pixels of a row show, one triangle after the other.
template <class Visit>
void for_each_shown(const TileRowOf<PrimitiveId>& shown, ColumnMask pixels, const Visit& visit) {
    while (pixels != 0) {
        const PrimitiveId triangle = shown[std::size_t(std::countr_zero(pixels))];
        const ColumnMask here = pixels & where_equal(shown.data(), triangle);
        pixels &= ~here;
        visit(triangle, here);
    }
}

class LayeredPass {
  public:
    LayeredPass(const Comparands& of, const OpenTiles& open, ClassMap& classes, std::span<Finding> findings)
        : of_(of), open_(open), classes_(classes), findings_(findings), sights_(of.view), memories_([&] {
              return Memories(of);
          }) {}

    LayeredFindings settle() {
        const Tiles& tiles = open_.tiles();
        asked_ = boxes_worth_layers(of_, open_, reach_px);
        if (asked_.reach_px() == 0) return all_left();
        const TrianglesByTile near(of_.scene, of_.view, asked_);
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

    static RowPlace row_of(int column, int row, int y) {
        return {column * Tiles::side_px, row * Tiles::side_px + y};
    }
    const OpenTiles::Row& pixels_of(const RowPlace& at) const {
        return open_.row(at.left / Tiles::side_px, at.y);
    }

    /// A row that will be asked about: one of the next tile with each of this one.
    void fetch_open(const RowPlace& at) const {
        if (pixels_of(at).pixels != 0) fetch(of_, at);
    }

    void settle_tile(int column, int row, const TrianglesByTile& near, Band& band) {
        if (open_.count(column, row) == 0) return;
        const bool is_next_open = column + 1 < open_.tiles().columns && open_.count(column + 1, row) != 0;
        Memories& memories = memories_.local();
        memories.acquaintance.forget_if_much();
        std::optional<Layers> layers;
        const std::size_t tile = open_.tiles().index(column, row);
        if (!asked_.of(tile).empty() && is_worth_layers(open_.count(column, row), near.of(tile).size()))
            layers.emplace(Layers::Shared{sights_, memories.acquaintance, memories.coplanar},
                           centres_of(open_, column, row), near.of(tile), bounds());
        const bool may_ask = layers && layers->are_known() && layers->widest_px() <= reach_px;
        for (int y = 0; y < Tiles::side_px; ++y) {
            const RowPlace at = row_of(column, row, y);
            if (is_next_open) fetch_open(row_of(column + 1, row, y));
            const OpenTiles::Row& pixels = pixels_of(at);
            if (pixels.pixels == 0) continue;
            const ColumnMask settled = may_ask ? settle_row(*layers, at, pixels, band.counts) : 0;
            std::uint32_t place = pixels.first;
            for (ColumnMask rest = pixels.pixels; rest != 0; rest &= rest - 1, ++place)
                if ((settled & -rest & rest) == 0)
                    band.left.push_back({{at.left + std::countr_zero(rest), at.y}, place});
        }
    }

    /// Writes what is certain.
    ColumnMask settle_row(Layers& layers, const RowPlace& at, const OpenTiles::Row& row,
                          ClassCounts& counts) {
        const ShownByBoth shown(of_, at);
        const Shown &ours = shown.ours, &theirs = shown.theirs;
        const ColumnMask open =
            layers.turn_to(at.y, row.pixels & ~where_equal(ours.primitive.data(), theirs.primitive.data()));
        if (open == 0) return 0;
        const Standings candidate = standings(layers, 0, ours, open);
        const Standings reference = standings(layers, 1, theirs, candidate.tied | candidate.visible);
        const ColumnMask settled = lawful(shown, row, reference.tied | reference.visible);
        const ColumnMask tied = settled & (candidate.tied | reference.tied);
        write(class_of(Standing::tied, Standing::visible), at, tied, counts);
        write(class_of(Standing::visible, Standing::visible), at, settled & ~tied, counts);
        if (!findings_.empty() && settled != 0) list(layers, shown, row, settled);
        return settled;
    }

    static Standings standings(Layers& layers, std::size_t renderer, const Shown& shown, ColumnMask pixels) {
        Standings all;
        for_each_shown(shown.primitive, pixels, [&](PrimitiveId triangle, ColumnMask here) {
            const Standings some = layers.standings(renderer, std::uint32_t(triangle), here);
            all.tied |= some.tied;
            all.visible |= some.visible;
        });
        return all;
    }

    /// Where the depths of both are lawful for certain; the first pass knows most.
    ColumnMask lawful(const ShownByBoth& shown, const OpenTiles::Row& row, ColumnMask pixels) {
        ColumnMask unknown = pixels & ~row.lawful;
        unknown &= lawful_by_laws(&LawOfBoth::candidate, shown.at, shown.ours, unknown);
        unknown &= lawful_by_laws(&LawOfBoth::reference, shown.at, shown.theirs, unknown);
        return pixels & (row.lawful | unknown);
    }

    /// One renderer's.
    ColumnMask lawful_by_laws(DepthLaw LawOfBoth::*law, const RowPlace& at, const Shown& shown,
                              ColumnMask pixels) {
        if (pixels == 0) return 0;
        const TileRowOf<float> camera_depth = shown.camera_depth();
        ColumnMask lawful = 0;
        for_each_shown(shown.primitive, pixels, [&](PrimitiveId triangle, ColumnMask here) {
            const DepthRow depth =
                depths_in_row(law_of(triangle).*law, of_.candidate.projection(), at, camera_depth);
            lawful |= here & at_least_zero(depth.ratio);
        });
        return lawful;
    }

    /// Lists the findings of pixels that are settled.
    void list(Layers& layers, const ShownByBoth& shown, const OpenTiles::Row& row, ColumnMask settled) {
        const RowPlace& at = shown.at;
        const Shown &ours = shown.ours, &theirs = shown.theirs;
        const TileRow eps_px = layers.eps_px(0);
        const TileRowOf<float> our_depth = ours.camera_depth(), their_depth = theirs.camera_depth();
        TileRowOf<std::uint32_t> place;
        std::uint32_t next = row.first;
        for (std::size_t i = 0; i < tile_columns; ++i) {
            place[i] = next;
            next += row.pixels >> i & 1;
        }
        for_each_shown(ours.primitive, settled, [&](PrimitiveId triangle, ColumnMask here) {
            const DepthRow depth =
                depths_in_row(law_of(triangle).candidate, of_.candidate.projection(), at, our_depth);
            for (; here != 0; here &= here - 1) {
                const auto i = std::size_t(std::countr_zero(here));
                findings_[place[i]] = {.x = at.left + int(i),
                                       .y = at.y,
                                       .verdict = classes_.at(at.left + int(i), at.y),
                                       .candidate = {triangle, our_depth[i]},
                                       .reference = {theirs.primitive[i], their_depth[i]},
                                       .eps_px = eps_px[i],
                                       .candidate_depth = {depth.low[i], depth.truth[i], depth.high[i]},
                                       .error_over_bound = depth.ratio[i]};
            }
        });
    }

    void write(PixelClass verdict, const RowPlace& at, ColumnMask pixels, ClassCounts& counts) {
        counts[std::size_t(verdict)] += std::uint64_t(std::popcount(pixels));
        if (pixels == 0) return;
        PixelClass* const row = &classes_.in_open(at.left, at.y);
        for (; pixels != 0; pixels &= pixels - 1) row[std::countr_zero(pixels)] = verdict;
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
    Sights<double> sights_;
    AskedBoxes asked_{0};  ///< of tiles that are worth it
    tbb::enumerable_thread_specific<Memories> memories_;
};

}  // namespace

LayeredFindings settle_layers(const Comparands& of, const OpenTiles& open, ClassMap& classes,
                              std::span<Finding> findings) {
    return LayeredPass(of, open, classes, findings).settle();
}

}  // namespace zproof
