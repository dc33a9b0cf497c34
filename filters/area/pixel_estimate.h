/// The truth at one pixel by samples: Embree says which triangle each view ray meets, the texture is
/// read there in double.
#pragma once

#include "filters/area/area_integral.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/scrambled_points.h"
#include "filters/area/surfaces.h"
#include "oracle/embree.h"

namespace zproof::oracle::area {

struct Estimate {
    glm::dvec3 mean{0};
    double half_width = 0;  ///< of the 95 % confidence interval, worst channel
};

class PixelEstimator {
  public:
    /// All arguments must outlive it.
    PixelEstimator(const Surfaces& surfaces, const Embree& embree, const View& view,
                   Reconstruction reconstruction)
        : surfaces_(surfaces),
          embree_(embree),
          view_(view),
          reconstruction_(reconstruction),
          weight_(weight_of(reconstruction)) {}

    /// Sixteen replicates of 16 to 1024 points, until half_width is at most 0.001. The interval is Student's
    /// of the replicates' means, and never less than 3 / n for n samples that all say the same ("rule of
    /// three": Hanley and Lippman-Hand 1983), times the greatest weight of a sample.
    Estimate at(int x, int y) const;

  private:
    glm::dvec3 colour(std::uint32_t triangle, const glm::dvec2& p_raster) const;
    void add(std::array<glm::dvec3, ScrambledPoints::replicates>& sums, glm::ivec2 pixel, int first,
             int last) const;

    const Surfaces& surfaces_;
    const Embree& embree_;
    const View& view_;
    Reconstruction reconstruction_;
    const PixelWeight& weight_;
    ScrambledPoints points_;
};

}  // namespace zproof::oracle::area
