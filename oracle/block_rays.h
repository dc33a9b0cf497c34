/// The rays of 4 x 4 pixels at a time, as Embree takes them: what does not change from pixel to pixel is
/// worked out once per view.
#pragma once

#include <embree3/rtcore.h>

#include "oracle/primary_ray.h"

namespace zproof::oracle {

class BlockRays {
  public:
    static constexpr int side = 4;  ///< pixels
    static constexpr int lanes = side * side;

    explicit BlockRays(const View& view);

    /// Fills origin, direction, tnear and tfar with the bits of primary_ray(view, left + lane % 4, top + lane
    /// / 4), and the rest with what Embree wants of a fresh ray.
    void aim(int left, int top, RTCRay16& rays) const;

    /// As PrimaryRay has it; the same for all.
    double origin_depth() const { return any_.origin_depth; }

  private:
    /// One coordinate of what varies, as primary_ray() adds it up.
    struct Coordinate {
        double first = 0, right = 0, up = 0, last = 0;
    };

    View view_;
    PrimaryRay any_;
    bool perspective_;
    Coordinate varying_[3];
};

}  // namespace zproof::oracle
