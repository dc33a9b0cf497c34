/// What a texture filter promises about its arithmetic: from these the filter reference derives how far a
/// faultless picture may stray from the definition (docs/filter-conformance.md).
///
/// Bits are those behind the binary point: what is known to b bits may err by 2^-b of its unit. Infinite bits
/// cost nothing. They are real numbers, so that a search may ask for the least that explains a picture.
#pragma once

#include <limits>

namespace zproof {

/// How the steps per pixel are known.
enum class StepRule {
    analytic,          ///< of the surface's plane, at the pixel's centre
    quad_differences,  ///< between the pixel's centre and its neighbour in the aligned 2 x 2 pixels
    // No promises but hypotheses:
    forward_differences,       ///< between the pixel's centre and the next one's
    centred_differences,       ///< between places half a pixel to either side
    wrapped_quad_differences,  ///< as above, of coordinates that were wrapped first
    wrapped_forward_differences,
    wrapped_centred_differences,
};

/// Weights that are multiples of 2^-bits: of a 2 x 2 read along each axis, and of a blend of two levels.
struct WeightLattice {
    enum class Rounding { nearest, down };
    double bits = std::numeric_limits<double>::infinity();
    Rounding rounding = Rounding::nearest;

    bool operator==(const WeightLattice&) const = default;
};

struct FilterPrecision {
    static constexpr double exact = std::numeric_limits<double>::infinity();

    double arithmetic_bits =
        53;  ///< unit roundoff 2^-b of all that leads from the scene to texel coordinates
    double coordinate_bits = 53;  ///< unit roundoff of coordinates and steps as the filter is given them, and
                                  ///< of its arithmetic with them
    double displacement_px = 0;   ///< the surface may be drawn this far beside its place, in x and in y
    double step_bits = exact;     ///< the steps per pixel, in lengths of the longest of their coordinates
    double place_bits = exact;    ///< place within a level, texels
    double weight_bits = exact;   ///< each weight of a 2 x 2 read, and of a blend of two levels
    double split_bits = exact;  ///< in a blend of two levels each level's share is split between columns, and
                                ///< a column's between texels: each split, as a weight of the whole blend
    double lod_bits = exact;    ///< LOD, levels
    double lod_below = 0;       ///< a sampler's LOD may lie so far below the rule's, levels; ellipses and
                                ///< OpenImageIO's methods work out a width of their own: no matter there
    double lod_above = 0;       ///< and so far above it
    double tap_bits = exact;    ///< where the taps of one lookup stand, in lengths of its axis
    double sum_bits = 53;       ///< unit roundoff of sums over texels: accumulation, summed-area tables
    int sum_roundings = 4096;   ///< chained in such a sum, weights included
    double texel_bits = 24;     ///< unit roundoff of stored texels of every level above 0: 11 is float16
    double colour_bits = 24;    ///< unit roundoff of the picture's numbers
    double code_error = 0;      ///< of a picture of 8-bit sRGB codes: how far a code may lie from its exact
                                ///< place, in codes; 1/2 is the nearest. 0: the picture is linear light
    WeightLattice weights_on{};  ///< no promise but a hypothesis: weights are rounded to these alone
    double level_offset = 0;  ///< another: places within each level lie so many of its texels on, in u and v

    bool operator==(const FilterPrecision&) const = default;
};

}  // namespace zproof
