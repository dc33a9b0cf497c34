#include "filters/methods/families.h"
#include "filters/methods/mip_reads.h"
#include "filters/stored/cardinality_table.h"

namespace zproof::texture {

namespace {

template <int texels>
const CardinalityTable& table() {
    static const CardinalityTable made{texels};
    return made;
}

/// The place in a level on the table's lattice, counted from 0: so many points a texel.
struct LatticePoint {
    std::int64_t u, v;

    LatticePoint(const MipReads& mips, int level, const glm::dvec2& place, int points)
        : u{nearest(place.x * mips.scale(level).x * points)},
          v{nearest(place.y * mips.scale(level).y * points)} {}

    static std::int64_t nearest(double x) { return texel_holding(x + 0.5); }
};

/// The whole number at or below i / n.
std::int64_t below(std::int64_t i, int n) { return (i - (i % n + n) % n) / n; }

/// The texels of the entry that is nearest to the place and LOD. Every level has a lattice of its own; they
/// are one where sizes halve evenly.
template <int texels>
struct TableReads {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        constexpr int steps = CardinalityTable::steps, places = CardinalityTable::places;
        const int coarsest = mips.coarsest(),
                  lod = int(std::floor(steps * mips.in_chain(lod_gl_maximum(footprint)) + 0.5));
        if (lod == steps * coarsest) return mips.nearest(coarsest, footprint.centre, 1, read);
        const int finest =
            std::clamp(lod / steps - 1, 0, std::max(0, coarsest + 1 - CardinalityTable::levels));
        const LatticePoint entry{mips, finest, footprint.centre, steps};
        for (const TableTap& tap : table<texels>().at(int(entry.u & (places - 1)),
                                                      int(entry.v & (places - 1)), lod - steps * finest)) {
            const int level = std::min(finest + tap.level, coarsest), points = steps << (level - finest);
            const LatticePoint own{mips, level, footprint.centre, points};
            const LinearImage& image = mips.levels[std::size_t(level)];
            const Addressing& wrap = mips.options.addressing;
            read(Tap{level, wrapped(wrap.u, below(own.u, points) + tap.column, image.width),
                     wrapped(wrap.v, below(own.v, points) + tap.row, image.height), tap.weight});
        }
    }
};

/// The table is made here, not by the first lookup.
template <int texels>
Sampler prepare_cardinality(const LinearImage& image, const FilterOptions& options) {
    table<texels>();
    return prepare_mipped<TableReads<texels>>(image, options);
}

template <int texels>
Method cardinality() {
    const std::string number = std::to_string(texels);
    return {.name = "cardinality-" + number,
            .card = {.footprint = "The longer of the pixel's two steps.",
                     .lod = "log2 of its length in texels, biased, clamped, rounded half up to a multiple of "
                            "1/8.",
                     .taps = "At most " + number +
                             " texels of three levels, with weights of sum 1: from the table of texels, "
                             "for a box as wide as the footprint is long. It has 8 places a texel and 8 "
                             "LODs a level; the nearest counts. Ties are settled by order: a mirrored "
                             "place may have other texels. At the last level its texel that holds "
                             "the place is read. Weights may be negative: the result may leave the "
                             "texels' range.",
                     .source = "Manson and Schaefer 2013, Cardinality-Constrained Texture Filtering: few "
                               "texels of several levels, by least squares, from a table. Its entries, the "
                               "way to choose texels and the box as the target are ours"},
            .prepare = prepare_cardinality<texels>};
}

}  // namespace

std::vector<Method> cardinality_methods() { return {cardinality<4>(), cardinality<8>()}; }

}  // namespace zproof::texture
