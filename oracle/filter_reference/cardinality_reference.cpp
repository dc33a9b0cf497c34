#include "oracle/filter_reference/cardinality_table.h"
#include "oracle/filter_reference/levels.h"

namespace zproof::oracle::filter_reference {

namespace {

/// Whole parts of what the interval may be, times a whole number.
std::vector<std::int64_t> parts(const Interval& place, int per_texel) {
    std::vector<std::int64_t> all;
    const double last = std::floor(per_texel * place.high());
    for (double part = std::floor(per_texel * place.low()); part <= last; ++part)
        all.push_back(std::int64_t(part));
    return all;
}

/// A cell along an axis: an eighth of the finer texel in a half of the coarser one, counted over all texels.
struct CellOfTwoLevels {
    std::int64_t eighth, half;

    std::int64_t texel(int level) const { return level == 0 ? eighth >> 3 : half >> 1; }
    int in_coarser() const { return int((half & 1) * 8 + (eighth & 7)); }
    double middle() const { return (double(eighth) + 0.5) / 8; }
};

/// Of a place this wide, which only a search for a cause asks for, nothing is told.
constexpr double widest_place = 2;

bool is_wider_than_cells(const TexelInterval& p) {
    return !(p.u.high() - p.u.low() < widest_place && p.v.high() - p.v.low() < widest_place);
}

std::vector<CellOfTwoLevels> cells_of(const Interval& in_finer, const Interval& in_coarser) {
    std::vector<CellOfTwoLevels> all;
    for (const std::int64_t eighth : parts(in_finer, 8))
        for (const std::int64_t half : parts(in_coarser, 2)) all.push_back({eighth, half});
    return all;
}

class Lookup {
  public:
    Lookup(const Levels& levels, const CardinalityTable& table, const FilterQuery& q)
        : levels_{levels}, table_{table}, q_{q}, centre_{q.footprint().centre} {}

    PermittedColours permitted() {
        const Interval lod = level_of(filter_reference::lod(LodRule::gl_maximum, q_.footprint()),
                                      levels_.settings(), levels_.count(), q_.precision);
        for (int level = int(std::floor(lod.low())); double(level) <= lod.high(); ++level)
            add_level(level, clamped(lod, level, level + 1.0) - Interval{double(level)});
        return std::move(all_);
    }

  private:
    TexelInterval place_of(int level) const {
        return place_in(levels_.at(level), levels_.at(0), centre_, q_.precision);
    }
    /// Sides of 8 to 16 eighths, rounded half up.
    void add_level(int level, const Interval& fraction) {
        const Interval side = widen(Interval{8} * exp2(fraction), 0x1p-48) + Interval{0.5};
        const int last = std::min(int(std::floor(side.high())), CardinalityTable::most_side);
        for (int eighths = std::max(int(std::floor(side.low())), 8); eighths <= last; ++eighths)
            add_side(level, eighths);
    }
    void add_side(int level, int eighths) {
        const int coarser = std::min(level + 1, int(levels_.count()) - 1);
        const TexelInterval fine = place_of(level), coarse = place_of(coarser);
        if (is_wider_than_cells(fine) || is_wider_than_cells(coarse)) throw UndecidedSign{};
        for (const CellOfTwoLevels& row : cells_of(fine.v, coarse.v))
            for (const CellOfTwoLevels& column : cells_of(fine.u, coarse.u))
                all_.push_back(eighths == 8 ? mean_of_one(level, column, row)
                                            : mean(level, column, row, eighths));
    }
    ColourRange mean_of_one(int level, const CellOfTwoLevels& column, const CellOfTwoLevels& row) const {
        const TexelInterval middle{Interval{column.middle()}, Interval{row.middle()}};
        return bilinear(levels_.at(level), levels_.settings().wrap, middle, q_.precision);
    }
    ColourRange mean(int finer, const CellOfTwoLevels& column, const CellOfTwoLevels& row,
                     int eighths) const {
        const WrapRules& wrap = levels_.settings().wrap;
        const CardinalityTable::Entry& entry = table_.at(eighths, column.in_coarser(), row.in_coarser());
        std::vector<IntervalImage::Texel> texels;
        glm::dvec3 sum{0}, radius{0};
        for (const WeightedTexel& t : entry) {
            const IntervalImage& image = levels_.at(finer + t.level);
            texels.push_back(image.at(wrapped_index(wrap.u, column.texel(t.level) + t.column, image.width),
                                      wrapped_index(wrap.v, row.texel(t.level) + t.row, image.height)));
            sum += t.weight * texels.back().value;
            radius += std::abs(t.weight) * texels.back().radius;
        }
        const double error = std::exp2(-q_.precision.weight_bits);
        for (const auto& texel : texels) radius += error * glm::abs(texel.value - sum);
        return around(sum, radius);
    }

    const Levels& levels_;
    const CardinalityTable& table_;
    const FilterQuery& q_;
    TexelInterval centre_;
    PermittedColours all_;
};

template <int most>
PermittedColours constrained(const Levels& levels, const FilterQuery& q) {
    static const CardinalityTable table{most};
    return Lookup{levels, table, q}.permitted();
}

}  // namespace

std::vector<Definition> cardinality_definitions() {
    return {{"cardinality-4", over_levels(constrained<4>)}, {"cardinality-8", over_levels(constrained<8>)}};
}

}  // namespace zproof::oracle::filter_reference
