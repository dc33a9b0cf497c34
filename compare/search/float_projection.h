/// World to raster for many corners at a time, in boxes of single precision: so most triangles are known to
/// be far from all that is asked about before any of their corners is looked up again.
#pragma once

#include <span>

#include "compare/search/float_box.h"

namespace zproof {

class FloatProjection {
  public:
    explicit FloatProjection(const BoxProjection& projection) : terms_(projection.terms()) {}

    /// Around the image of each corner, as BoxProjection says; everywhere, where that has no place for it.
    /// `boxes` has as many places as there are corners.
    void project(std::span<const glm::vec3> p_world, std::span<FloatBox> boxes) const;

  private:
    BoxProjection::Terms terms_;
};

}  // namespace zproof
