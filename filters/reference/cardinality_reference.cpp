#include <optional>

#include "filters/reference/cardinality_taps.h"
#include "filters/reference/levels.h"

namespace zproof::oracle::filter_reference {

namespace {

/// What solving in double may cost a weight, theirs and ours: tests/filters/cardinality_test.cpp compares
/// them all.
constexpr double weight_error = 0x1p-30;

/// No entry's absolute weights add up to more: the same test.
constexpr double most_absolute_weights = 5;

/// Lattice points that may be the nearest one, first to last.
struct Points {
    std::int64_t first, last;
};

Points points_near(const Interval& place, int a_texel) {
    const Interval at = Interval{double(a_texel)} * place + Interval{0.5};
    return {std::int64_t(std::floor(at.low())), std::int64_t(std::floor(at.high()))};
}

/// A place this wide, a texel of the finest level, permits all that any entry can make of the levels.
bool covers_a_texel(const TexelInterval& place) {
    return !(place.u.high() - place.u.low() < 1 && place.v.high() - place.v.low() < 1);
}

/// The texels that hold them.
Points texels_holding(const Points& points, int a_texel) {
    const auto holding = [&](std::int64_t i) { return std::int64_t(std::floor(double(i) / a_texel)); };
    return {holding(points.first), holding(points.last)};
}

struct Place {
    Points u, v;
};

class Lookup {
  public:
    Lookup(const Levels& levels, const FilterQuery& q)
        : levels_{levels}, centre_{q.footprint().centre}, precision_{q.precision} {}

    /// Every entry that may be the nearest.
    void add(int lod, ChosenTexels& table, PermittedColours& all) const {
        const int coarsest = int(levels_.count()) - 1;
        if (lod == 8 * coarsest) {
            for (const ColourRange& range : levels_.nearest_in(coarsest, centre_, precision_))
                all.push_back(range);
            return;
        }
        const int finest = std::max(0, std::min(lod / 8 - 1, coarsest - 2));
        if (covers_a_texel(place_of(finest))) return all.push_back(any_entry(finest));
        const Place near = points_in(finest, 8);
        for (std::int64_t v = near.v.first; v <= near.v.last; ++v)
            for (std::int64_t u = near.u.first; u <= near.u.last; ++u)
                all.push_back(sum_of(table.at(int(u & 31), int(v & 31), lod - 8 * finest), finest));
    }

  private:
    TexelInterval place_of(int level) const {
        return place_in(levels_.at(level), levels_.at(0), centre_, precision_);
    }
    Place points_in(int level, int a_texel) const {
        const TexelInterval place = place_of(level);
        return {points_near(place.u, a_texel), points_near(place.v, a_texel)};
    }
    /// Weights of sum 1 leave the middle of the texels' range by their absolute sum times its half at most.
    ColourRange any_entry(int finest) const {
        ColourRange range = levels_.at(finest).range;
        for (int level = finest; level <= std::min(finest + 2, int(levels_.count()) - 1); ++level)
            range = hull(range, levels_.at(level).range);
        const double error = weight_error + std::exp2(-precision_.weight_bits);
        return around((range.low + range.high) / 2.0,
                      (most_absolute_weights + 8 * error) * (range.high - range.low) / 2.0);
    }
    /// Weights that are off have a sum of 1, too: each moves the sum by its error times the texel's distance
    /// from anything, here from the middle of the sum.
    ColourRange sum_of(const std::vector<ChosenTexel>& texels, int finest) const {
        ColourRange sum;
        std::vector<ColourRange> read;
        for (const ChosenTexel& texel : texels) {
            const int level = std::min(finest + texel.level, int(levels_.count()) - 1),
                      a_texel = 8 << (level - finest);
            const Place near = points_in(level, a_texel);
            read.push_back(
                any_of(level, texel, {texels_holding(near.u, a_texel), texels_holding(near.v, a_texel)}));
            sum = sum + Interval{texel.weight} * read.back();
        }
        const glm::dvec3 middle = (sum.low + sum.high) / 2.0;
        glm::dvec3 farthest{0};
        for (const ColourRange& one : read)
            farthest += glm::max(glm::abs(one.low - middle), glm::abs(one.high - middle));
        const glm::dvec3 error = (weight_error + std::exp2(-precision_.weight_bits)) * farthest;
        return {sum.low - error, sum.high + error};
    }
    ColourRange any_of(int level, const ChosenTexel& texel, const Place& holding) const {
        const IntervalImage& image = levels_.at(level);
        const WrapRules& wrap = levels_.settings().wrap;
        std::optional<ColourRange> range;
        for (std::int64_t row = holding.v.first; row <= holding.v.last; ++row)
            for (std::int64_t column = holding.u.first; column <= holding.u.last; ++column) {
                const auto& t = image.at(wrapped_index(wrap.u, column + texel.column, image.width),
                                         wrapped_index(wrap.v, row + texel.row, image.height));
                const ColourRange one = around(t.value, t.radius);
                range = range ? hull(*range, one) : one;
            }
        return *range;
    }

    const Levels& levels_;
    TexelInterval centre_;
    const FilterPrecision& precision_;
};

Definition cardinality(int texels) {
    return {"cardinality-" + std::to_string(texels),
            over_levels([texels](const Levels& levels, const FilterQuery& q) {
                const Interval level = level_of(lod(LodRule::gl_maximum, q.footprint()), levels.settings(),
                                                levels.count(), q.precision);
                const Points lods = points_near(level, 8);
                PermittedColours all;
                for (std::int64_t lod = lods.first; lod <= lods.last; ++lod)
                    Lookup{levels, q}.add(int(lod), chosen_texels(texels), all);
                return all;
            })};
}

}  // namespace

std::vector<Definition> cardinality_definitions() { return {cardinality(4), cardinality(8)}; }

}  // namespace zproof::oracle::filter_reference
