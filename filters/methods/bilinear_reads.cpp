#include "filters/methods/bilinear_rule.h"
#include "filters/methods/families.h"
#include "filters/stored/two_reads_table.h"

namespace zproof::texture {

namespace {

const TwoReadsTable& two_reads_table() {
    static const TwoReadsTable made;
    return made;
}

/// The eighth of the coarser texel that holds the place along an axis: its half as the coarser level has it,
/// its quarter of the finer texel as the finer level has it.
int cell_holding(double in_finer, double in_coarser) {
    return int((texel_holding(2 * place_on_line(in_coarser)) & 1) * 4 +
               (texel_holding(4 * place_on_line(in_finer)) & 3));
}

struct TwoDisplacedReads {
    void operator()(const MipReads& mips, const Footprint& footprint, auto&& read) const {
        const glm::dvec2& centre = footprint.centre;
        const double lod = mips.in_chain(lod_gl_maximum(footprint));
        if (lod >= mips.coarsest()) return mips.bilinear(mips.coarsest(), centre, 1, read);
        const int finer = std::max(int(lod) - 1, 0);
        const int side_eighths = int(8 * std::exp2(lod - finer) + 0.5);
        const glm::dvec2 in_finer = centre * mips.scale(finer), in_coarser = centre * mips.scale(finer + 1);
        const TwoReads reads = two_reads_table().at(
            side_eighths, {cell_holding(in_finer.x, in_coarser.x), cell_holding(in_finer.y, in_coarser.y)});
        const double share = reads.share / 64.0;
        if (share > 0) mips.bilinear_in(finer, in_finer + glm::dvec2{reads.finer} / 8.0, share, read);
        if (share < 1)
            mips.bilinear_in(finer + 1, in_coarser + glm::dvec2{reads.coarser} / 8.0, 1 - share, read);
    }
};

/// The table is made here, not by the first lookup.
Sampler prepare_two_reads(const LinearImage& image, const FilterOptions& options) {
    two_reads_table();
    return prepare_bilinear<TwoDisplacedReads>(image, options);
}

}  // namespace

std::vector<Method> bilinear_reads_methods() {
    return {
        {.name = "bilinear-reads-2",
         .card =
             {.footprint = "The longer of the pixel's two steps.",
              .lod = "log2 of its length in texels, biased, clamped. m is the LOD rounded down, less 1, at "
                     "least 0.",
              .taps = "One bilinear read of level m, one of m + 1, blended. How far each stands beside the "
                      "place, and the blend, are from the table of reads, for a square of side 2^(LOD - m) "
                      "texels of m, rounded half up to eighths. A read of weight 0 is left out; no weight is "
                      "negative. At the last level's LOD that level alone is read bilinearly.",
              .source = "Manson and Schaefer 2014, Bilinear Accelerated Filter Approximation: two bilinear "
                        "reads of adjacent levels, displaced and blended by least squares, from a table. "
                        "Their tables are not at hand: the square as the target, cells, steps and search "
                        "are ours"},
         .prepare = prepare_two_reads}};
}

}  // namespace zproof::texture
