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

/// Open pixels of a tile from which on it is worth the trouble to look at whole rows.
constexpr std::uint32_t many = 64;

/// In the widest own eps of a tile's answers. Few squares grow beyond it; those that do are left.
constexpr double reach_over_eps = 2;

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
    LanesOf<PrimitiveId> primitive;
    LanesOf<float> camera_depth;

    Shown(const Frame& frame, const LaneRow& at) {
        const auto left = std::size_t(at.left),
                   count = std::min(lane_count, frame.primitive.row(at.y).size() - left);
        primitive.fill(PrimitiveId::none);
        camera_depth.fill(background_depth);
        std::ranges::copy(frame.primitive.row(at.y).subspan(left, count), primitive.begin());
        std::ranges::copy(frame.camera_depth.row(at.y).subspan(left, count), camera_depth.begin());
    }
    LaneMask shows(PrimitiveId one) const {
        LaneMask mask = 0;
        for (std::size_t i = 0; i < lane_count; ++i) mask |= LaneMask(primitive[i] == one) << i;
        return mask;
    }
};

LaneMask differ(const Shown& a, const Shown& b) {
    LaneMask mask = 0;
    for (std::size_t i = 0; i < lane_count; ++i) mask |= LaneMask(a.primitive[i] != b.primitive[i]) << i;
    return mask;
}

/// What is certain of one renderer's answers along a row.
struct Certain {
    LaneMask tied = 0, visible = 0;  ///< with a lawful depth
    DepthRow depth{};                ///< there

    void add(const Layers::Standings& standings, const DepthRow& row) {
        LaneMask lawful = 0;
        for (std::size_t i = 0; i < lane_count; ++i) lawful |= LaneMask(row.ratio[i] >= 0) << i;
        tied |= standings.tied & lawful;
        visible |= standings.visible & lawful;
        for (LaneMask rest = (standings.tied | standings.visible) & lawful; rest != 0; rest &= rest - 1) {
            const auto i = std::size_t(std::countr_zero(rest));
            depth.low[i] = row.low[i];
            depth.truth[i] = row.truth[i];
            depth.high[i] = row.high[i];
            depth.ratio[i] = row.ratio[i];
        }
    }
};

class LayeredPass {
  public:
    LayeredPass(const Comparands& of, std::span<const PixelPlace> open, Verdict& verdict)
        : of_(of),
          open_(open),
          verdict_(verdict),
          sights_(of.view),
          tiles_(of.view, open),
          memories_([&] { return Memories(of); }),
          reach_px_(tiles_.tiles().count()) {}

    LayeredFindings settle() {
        const AskedBoxes asked = asked_boxes();
        if (std::ranges::all_of(reach_px_, [](double reach) { return reach == 0; })) return all_left();
        const TrianglesByTile near(of_.scene, of_.view, asked);
        std::vector<LayeredFindings> bands(std::size_t(tiles_.tiles().rows));
        tbb::parallel_for(0, tiles_.tiles().rows, [&](int row) {
            for (int column = 0; column < tiles_.tiles().columns; ++column)
                settle_tile(column, row, near, bands[std::size_t(row)]);
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

    /// For tiles that are worth it; notes their reach.
    AskedBoxes asked_boxes() {
        const Tiles& tiles = tiles_.tiles();
        AskedBoxes asked(tiles.count());
        tbb::parallel_for(0, tiles.rows, [&](int row) {
            for (int column = 0; column < tiles.columns; ++column) {
                const OpenTiles::Tile& tile = tiles_.at(column, row);
                if (tile.count < many) continue;
                Around box = centres(column, row);
                const double reach = reach_px(tile, column, row, box);
                if (!std::isfinite(reach)) continue;
                reach_px_[tiles.index(column, row)] = reach;
                box.half_x += reach, box.half_y += reach;
                asked.add(tiles.index(column, row), raster_box(box), reach);
            }
        });
        return asked;
    }

    LaneRow row_of(int column, int row, std::size_t y) const {
        return {column * Tiles::side_px, row * Tiles::side_px + int(y)};
    }

    /// Of a tile's open pixels.
    Around centres(int column, int row) const {
        LaneMask any = 0;
        Box box;
        const OpenTiles::Tile& tile = tiles_.at(column, row);
        for (std::size_t y = 0; y < tile.rows.size(); ++y) {
            any |= tile.rows[y].pixels;
            if (tile.rows[y].pixels != 0) box.add(column * Tiles::side_px, row_of(column, row, y).y);
        }
        box.add(column * Tiles::side_px + int(std::bit_width(any)) - 1, box.top);
        return {box.middle_x(), box.middle_y(), 0.5 * (box.right - box.left), 0.5 * (box.bottom - box.top)};
    }

    double reach_px(const OpenTiles::Tile& tile, int column, int row, const Around& centres) {
        Acquaintance& acquaintance = memories_.local().acquaintance;
        double widest = 0;
        for (std::size_t y = 0; y < tile.rows.size(); ++y) {
            if (tile.rows[y].pixels == 0) continue;
            for (const Witness* witness : {&of_.candidate, &of_.reference}) {
                const ViewBounds& bounds = witness->bounds();
                widest = std::max(widest, bounds.background_eps_px());
                const Shown shown(witness->frame(), row_of(column, row, y));
                PrimitiveId latest = PrimitiveId::none;
                for (LaneMask rest = tile.rows[y].pixels; rest != 0; rest &= rest - 1) {
                    const PrimitiveId one = shown.primitive[std::size_t(std::countr_zero(rest))];
                    if (one == latest || std::size_t(one) >= of_.scene.triangles.size()) continue;
                    latest = one;
                    const auto triangle = std::uint32_t(one);
                    widest = std::max(widest, acquaintance.of(triangle, bounds)
                                                  .most_eps_px(acquaintance.of(triangle).filter, centres));
                }
            }
        }
        return reach_over_eps * widest;
    }

    void settle_tile(int column, int row, const TrianglesByTile& near, LayeredFindings& found) {
        const OpenTiles::Tile& tile = tiles_.at(column, row);
        if (tile.count == 0) return;
        const std::size_t index = tiles_.tiles().index(column, row);
        std::optional<Layers> layers;
        if (reach_px_[index] > 0) {
            Memories& memories = memories_.local();
            layers.emplace(Layers::Shared{sights_, memories.acquaintance, memories.coplanar},
                           centres(column, row), near.of(index), bounds());
        }
        for (std::size_t y = 0; y < tile.rows.size(); ++y) {
            const OpenTiles::Row& pixels = tile.rows[y];
            LaneMask settled = 0;
            if (pixels.pixels != 0 && layers && layers->are_known())
                settled = settle_row(*layers, row_of(column, row, y), pixels, reach_px_[index], found.counts);
            for (LaneMask rest = pixels.pixels & ~settled; rest != 0; rest &= rest - 1)
                found.left.push_back(place_of(pixels, std::size_t(std::countr_zero(rest))));
        }
    }

    static std::uint32_t place_of(const OpenTiles::Row& row, std::size_t lane) {
        const LaneMask before = row.pixels & ((LaneMask{1} << lane) - 1);
        return row.first + std::uint32_t(std::popcount(before));
    }

    LaneMask settle_row(Layers& layers, const LaneRow& at, const OpenTiles::Row& row, double reach_px,
                        ClassCounts& counts) {
        const Shown ours(of_.candidate.frame(), at), theirs(of_.reference.frame(), at);
        layers.turn_to(at.y);
        LaneMask open = row.pixels & differ(ours, theirs);
        for (std::size_t renderer = 0; renderer < 2; ++renderer)
            for (std::size_t i = 0; i < lane_count; ++i)
                if (!(layers.eps_px(renderer)[i] <= reach_px)) open &= ~(LaneMask{1} << i);
        const Certain candidate = certain(layers, 0, at, ours, open);
        const Certain reference = certain(layers, 1, at, theirs, candidate.tied | candidate.visible);
        const LaneMask settled = reference.tied | reference.visible;
        for (LaneMask rest = settled; rest != 0; rest &= rest - 1) {
            const auto i = std::size_t(std::countr_zero(rest));
            const bool is_tied = ((candidate.tied | reference.tied) >> i & 1) != 0;
            const PixelClass verdict =
                class_of(is_tied ? Standing::tied : Standing::visible, Standing::visible);
            ++counts[std::size_t(verdict)];
            verdict_.classes.at(at.left + int(i), at.y) = verdict;
            verdict_.findings[place_of(row, i)] = {
                .x = at.left + int(i),
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

    Certain certain(Layers& layers, std::size_t renderer, const LaneRow& at, const Shown& shown,
                    LaneMask open) {
        Certain all;
        for (LaneMask rest = open; rest != 0;) {
            const PrimitiveId one = shown.primitive[std::size_t(std::countr_zero(rest))];
            const LaneMask pixels = rest & shown.shows(one);
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
    std::vector<double> reach_px_;  ///< by tile; 0 where it is not worth the trouble
};

}  // namespace

LayeredFindings settle_layers(const Comparands& of, std::span<const PixelPlace> open, Verdict& verdict) {
    return LayeredPass(of, open, verdict).settle();
}

}  // namespace zproof
