/// The bounds of a ray caster in float64 that meets planes (docs/bounds.md).
#pragma once

#include "compare/bounds/aim.h"
#include "compare/bounds/triangle_bounds.h"
#include "frame/precision.h"

namespace zproof {

class PlaneRayBounds {
  public:
    PlaneRayBounds(const ViewFacts& facts, const PlaneRayPrecision& precision);

    TriangleBounds of(const ViewFacts& facts, const TriangleExtent& extent) const;
    double background_eps_px() const { return aim_.px; }

  private:
    PlaneRayPrecision precision_;
    Aim aim_;
};

}  // namespace zproof
