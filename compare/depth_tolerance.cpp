#include "compare/depth_tolerance.h"

#include "compare/tolerance_terms.h"

namespace zproof {

DepthTolerance tolerance_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                            const PixelBox& part, Reach reach) {
    return tolerance_of<double>(candidate, reference, projection, part, reach);
}

}  // namespace zproof
