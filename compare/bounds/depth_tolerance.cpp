#include "compare/bounds/depth_tolerance.h"

#include "compare/bounds/tolerance_terms.h"

namespace zproof {

Tolerances tolerances_of(const DepthLaw& candidate, const DepthLaw& reference, Projection projection,
                         const PixelBox& part) {
    return tolerances_of<double>(candidate, reference, projection, part);
}

}  // namespace zproof
