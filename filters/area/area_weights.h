/// The weight that the area integral gives to each texel of a pixel: what area_truth() sums.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "filters/area/area_integral.h"

namespace zproof::oracle {

/// A texel on the endless line of columns and rows, before any wrap.
struct TexelWeight {
    int material = 0;
    std::int64_t column = 0, row = 0;
    double weight = 0;  ///< of a pixel; texels may be listed more than once
};

/// A pixel's mean is the sum of weight x base_color_factor x texel over its texels, and of what has no
/// texture.
class AreaWeights {
  public:
    /// Scene and view must outlive it.
    AreaWeights(const Scene& scene, const View& view, Reconstruction reconstruction);
    ~AreaWeights();
    AreaWeights(const AreaWeights&) = delete;
    AreaWeights& operator=(const AreaWeights&) = delete;

    /// None where area_truth() samples the pixel. May be asked from many threads.
    std::optional<std::vector<TexelWeight>> at(int x, int y) const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace zproof::oracle
