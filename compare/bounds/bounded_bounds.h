/// The bounds of a renderer that declares them itself (BoundedPrecision).
#pragma once

#include "compare/bounds/triangle_bounds.h"
#include "compare/bounds/view_facts.h"
#include "frame/precision.h"

namespace zproof {

class BoundedBounds {
  public:
    BoundedBounds(const ViewFacts& facts, const BoundedPrecision& precision);

    TriangleBounds of(const ViewFacts& facts, const TriangleExtent& extent) const;
    double background_eps_px() const { return precision_.eps_px; }

  private:
    BoundedPrecision precision_;
    double depth_absolute_;  ///< scene units, the share of far - near included
};

}  // namespace zproof
