/// Level-of-detail rules over intervals: every LOD that a footprint known within intervals may have.
#pragma once

#include "filters/reference/filter_query.h"

namespace zproof::oracle::filter_reference {

enum class LodRule {
    gl_maximum,          ///< log2 of the longer step (OpenGL 4.6, 8.14.1)
    ellipse_major,       ///< log2 of the longer semi-axis of the ellipse (Direct3D 11.3, 7.18.11)
    root_mean_square,    ///< log2 of the root of the mean square of both steps' lengths
    root_of_area,        ///< half of log2 of the determinant
    largest_coordinate,  ///< log2 of the largest of the four coordinates
    mesa_longer_step,    ///< as gl_maximum, its logarithm half the one below of the square
    pbrt,                ///< one level blurrier than that (pbrt-v4, MIPMap)
};

/// The semi-axes of the image of the unit circle, major >= minor, texels.
struct Axes {
    Interval major, minor;
};
Axes axes(const PixelFootprint& footprint);

Interval area(const PixelFootprint& footprint);  ///< absolute value of the Jacobian's determinant

/// e + m - 1 for m 2^e, 1 <= m < 2: log2 but for at most 0.0861 (Mesa, lp_build_fast_log2 and
/// util_fast_log2).
Interval chord_log2(const Interval& a);

Interval lod(LodRule rule, const PixelFootprint& footprint);

/// Biased, then clamped to the settings, then to the chain. Before clamping it is widened by the declared
/// bits, by what may lie below and above, and by what its arithmetic may cost.
Interval level_of(const Interval& lod, const Settings& settings, std::size_t level_count,
                  const FilterPrecision& precision);

}  // namespace zproof::oracle::filter_reference
