#include "compare/diagnosis/hypotheses/plane_depth.h"

#include <cmath>
#include <limits>

namespace zproof {

ReportedDepth plane_depth(const Neighbour& triangle, Projection projection, const glm::dvec2& offset_px) {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const double relative = triangle.bounds.depth_relative, absolute = triangle.bounds.depth_absolute;
    if (!triangle.image || !triangle.is_plane_known || !std::isfinite(relative + absolute))
        return {-unbounded, unbounded};
    const Affine<double>& f = triangle.image->inverse_depth;
    const double here = f.c + f.a * offset_px.x + f.b * offset_px.y;
    const double room = triangle.bounds.eps_px * triangle.gradient + triangle.plane_error +
                        triangle.bounds.inverse_depth_error;
    double low = -(here + room), high = -(here - room);
    if (projection == Projection::perspective) {
        if (here + room <= 0) return {unbounded, unbounded};
        low = 1 / (here + room);
        high = here - room > 0 ? 1 / (here - room) : unbounded;
    }
    return {low - relative * std::abs(low) - absolute, high + relative * std::abs(high) + absolute};
}

}  // namespace zproof
