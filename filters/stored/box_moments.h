/// Mean and variance of a texture over a box, from two summed-area tables: of the texels and of their
/// squares. These are the moments of summed-area variance shadow maps (Lauritzen 2007, GPU Gems 3, chapter
/// 8). This is no filter of colour: the mean is that of a summed-area table, and the variance tells what a
/// mean leaves out.
#pragma once

#include "filters/stored/summed_area.h"

namespace zproof::texture {

/// Channel by channel.
struct Moments {
    glm::dvec4 mean{0}, variance{0};  ///< the variance is at least 0
};

class MomentTables {
  public:
    MomentTables(const LinearImage& image, const Addressing& addressing, SatStorage storage);

    /// The moments of the texels as squares, over a box anywhere on the wrapped texture.
    Moments over(const Extent& columns, const Extent& rows) const;

  private:
    Addressing addressing_;
    SummedArea texels_, squares_;
};

/// The largest share of any distribution with these moments that may lie at or above t: Chebyshev's one-sided
/// inequality, variance / (variance + (t - mean)^2) above the mean, else 1. Two values, of which t is the
/// upper one, reach it (Donnelly and Lauritzen 2006).
double most_at_or_above(double mean, double variance, double t);

}  // namespace zproof::texture
