#include "texture/constrained_texels.h"
#include "texture/methods/families.h"
#include "texture/methods/mip_reads.h"

namespace zproof::texture {

namespace {

/// Where a place lies along an axis of a level and of the next coarser one.
struct PlaceOfTwoLevels {
    std::int64_t finer, coarser;  ///< the texels that hold it
    int cell;                     ///< of the coarser texel's 16

    PlaceOfTwoLevels(double in_finer, double in_coarser) {
        const std::int64_t eighth = texel_holding(8 * place_on_line(in_finer)),
                           half = texel_holding(2 * place_on_line(in_coarser));
        finer = eighth >> 3, coarser = half >> 1;
        cell = int((half & 1) * 8 + (eighth & 7));
    }
};

double middle_of_eighth(double place) { return (double(texel_holding(8 * place)) + 0.5) / 8; }

template <int most>
struct Constrained {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const double lod = mips.in_chain(lod_gl_maximum(footprint));
        const int level = int(lod);  // rounded down: it is not negative
        const int side_eighths = int(8 * std::exp2(lod - level) + 0.5);
        if (side_eighths > 8) return read_entry(mips, level, side_eighths, footprint.centre, read);
        const glm::dvec2 place = footprint.centre * mips.scale(level);
        read_bilinear(mips.levels[std::size_t(level)], mips.options.addressing,
                      {middle_of_eighth(place.x), middle_of_eighth(place.y)},
                      Tap{.image = level, .weight = 1}, read);
    }

  private:
    static void read_entry(const MipReads& mips, int level, int side_eighths, const glm::dvec2& centre,
                           auto&& read) {
        static const ConstrainedTexels table{most, WeightTotal::one};
        const glm::dvec2 in_finer = centre * mips.scale(level), in_coarser = centre * mips.scale(level + 1);
        const PlaceOfTwoLevels u{in_finer.x, in_coarser.x}, v{in_finer.y, in_coarser.y};
        for (const ConstrainedTexel& texel : table.at(side_eighths, u.cell, v.cell)) {
            if (texel.level == ConstrainedTexel::Level::finer)
                read(tap(mips, level, u.finer, v.finer, texel));
            else
                read(tap(mips, level + 1, u.coarser, v.coarser, texel));
        }
    }
    static Tap tap(const MipReads& mips, int level, std::int64_t column, std::int64_t row,
                   const ConstrainedTexel& texel) {
        const LinearImage& image = mips.levels[std::size_t(level)];
        const Addressing& wrap = mips.options.addressing;
        return {level, wrapped(wrap.u, column + texel.column, image.width),
                wrapped(wrap.v, row + texel.row, image.height), texel.weight};
    }
};

template <int most>
Method cardinality_method() {
    const std::string count = std::to_string(most);
    return {
        .name = "cardinality-" + count,
        .card = {.footprint = "The longer of the pixel's two steps.",
                 .lod = "log2 of its length in texels; L is the LOD rounded down.",
                 .taps = "At most " + count +
                         " texels of levels L and L + 1, which stand for a mean: that of L's texels, as "
                         "squares, over a square. Its side is 2^(LOD - L) texels of L, rounded half up "
                         "to eighths; its centre is the middle of the cell that holds the place, of 8 x "
                         "8 in L's texel. Where the side is 1: the mean itself, which is bilinear at "
                         "that centre. Else texels are chosen one by one, a texel of L + 1 being taken "
                         "for the mean of 2 x 2 of L. Each time it is the one with which least squares "
                         "leave the least of the mean's weights in L. Of equal ones L + 1's come first, "
                         "then upper rows, then left columns; none is chosen where nothing is left. Then "
                         "the weights are those of least squares whose sum is 1. Which half of L + 1's "
                         "texel holds the place, along either axis, tells how the two levels lie. "
                         "Weights may be negative: the result may leave the texels' range.",
                 .source = "Manson and Schaefer 2013, Cardinality-Constrained Texture Filtering: a fixed "
                           "number of texels of several levels, least squares, a table. Their table is not "
                           "at hand: the mean over a square, the cells and the rule of choice are ours"},
        .prepare = prepare_mipped<Constrained<most>>};
}

}  // namespace

std::vector<Method> cardinality_methods() { return {cardinality_method<4>(), cardinality_method<8>()}; }

}  // namespace zproof::texture
