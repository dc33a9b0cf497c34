#include <algorithm>

#include "filters/reference/levels.h"
#include "filters/reference/two_reads.h"

namespace zproof::oracle::filter_reference {

namespace {

/// A place this wide, two texels, permits any mean of the levels.
bool covers_two_texels(const TexelInterval& place) {
    return !(place.u.high() - place.u.low() < 2 && place.v.high() - place.v.low() < 2);
}

/// What floor(parts * place) modulo `cycle` may be.
std::vector<int> parts_holding(const Interval& place, int parts, int cycle) {
    std::vector<int> all;
    const double last = std::floor(parts * place.high());
    for (double part = std::floor(parts * place.low()); part <= last; ++part) {
        const int within = int(part - cycle * std::floor(part / cycle));
        if (std::ranges::find(all, within) == all.end()) all.push_back(within);
    }
    return all;
}

/// Eighths of the coarser texel: a half of it, and a quarter of the finer texel.
std::vector<int> cells_holding(const Interval& in_finer, const Interval& in_coarser) {
    std::vector<int> all;
    for (const int half : parts_holding(in_coarser, 2, 2))
        for (const int quarter : parts_holding(in_finer, 4, 4)) all.push_back(4 * half + quarter);
    return all;
}

class DisplacedReads {
  public:
    DisplacedReads(const Levels& levels, const FilterQuery& q)
        : levels_{levels}, precision_{q.precision}, centre_{q.footprint().centre} {}

    /// All that may be read where the LOD is of this whole part.
    void add(int whole, const Interval& lod, PermittedColours& all) const {
        const int finer = std::max(whole - 1, 0);
        const Interval above = clamped(lod, whole, whole + 1.0) - Interval{double(finer)},
                       side = widen(Interval{8} * exp2(above), 0x1p-46) + Interval{0.5};
        const int widest = std::min(int(std::floor(side.high())), TwoReadsSearch::most_side);
        for (int eighths = std::max(int(std::floor(side.low())), 8); eighths <= widest; ++eighths)
            add_side(finer, eighths, all);
    }

  private:
    void add_side(int finer, int eighths, PermittedColours& all) const {
        const TexelInterval fine = place_of(finer), coarse = place_of(finer + 1);
        if (covers_two_texels(fine) || covers_two_texels(coarse))
            return all.push_back(hull(levels_.at(finer).range, levels_.at(finer + 1).range));
        for (const int row : cells_holding(fine.v, coarse.v))
            for (const int column : cells_holding(fine.u, coarse.u)) {
                const TwoReadsFound& reads = two_reads_search().at(eighths, column, row);
                const double share = on_lattice(reads.finer_64ths / 64.0, precision_);
                all.push_back(
                    blended(read(finer + 1, coarse, reads.coarser), read(finer, fine, reads.finer),
                            clamped(widen(Interval{share}, std::exp2(-precision_.weight_bits)), 0, 1)));
            }
    }
    TexelInterval place_of(int level) const {
        return place_in(levels_.at(level), levels_.at(0), centre_, precision_);
    }
    /// The displaced place, at most 2 texels farther out, is rounded once more.
    ColourRange read(int level, const TexelInterval& place, const std::array<int, 2>& eighths) const {
        const auto moved = [&](const Interval& p, int by) {
            const double farthest = std::max(std::abs(p.low()), std::abs(p.high())) + 2;
            return widen(p + Interval{by / 8.0}, std::exp2(-precision_.coordinate_bits) * farthest);
        };
        return bilinear(levels_.at(level), levels_.settings().wrap,
                        {moved(place.u, eighths[0]), moved(place.v, eighths[1])}, precision_);
    }

    const Levels& levels_;
    const FilterPrecision& precision_;
    TexelInterval centre_;
};

PermittedColours two_reads(const Levels& levels, const FilterQuery& q) {
    const Interval level =
        level_of(lod(LodRule::gl_maximum, q.footprint()), levels.settings(), levels.count(), q.precision);
    const int last = int(levels.count()) - 1;
    PermittedColours all;
    if (level.high() >= last) all.push_back(levels.bilinear_in(last, q.footprint().centre, q.precision));
    for (int whole = int(std::floor(level.low())); whole < last && double(whole) <= level.high(); ++whole)
        DisplacedReads{levels, q}.add(whole, level, all);
    return all;
}

}  // namespace

std::vector<Definition> bilinear_reads_definitions() {
    return {{"bilinear-reads-2", over_levels(two_reads)}};
}

}  // namespace zproof::oracle::filter_reference
