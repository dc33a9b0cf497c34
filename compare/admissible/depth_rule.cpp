#include "compare/admissible/depth_rule.h"

#include <cmath>

#include "math/interval.h"
#include "math/rational.h"

namespace zproof {

namespace {

/// depth + a >= low - |low| r at the inverse depth closest to the viewer, without division by inverse depth.
template <class Number>
bool is_not_too_near(const Number& inverse_depth, const LocalBounds& local, float depth,
                     Projection projection) {
    const Number r(local.depth_relative), a(local.depth_absolute), z{double(depth)}, one(1);
    if (projection == Projection::parallel)
        return sign((z + a) - (-inverse_depth - magnitude(inverse_depth) * r)) >= 0;
    return sign(inverse_depth) > 0 && sign((z + a) * inverse_depth - (one - r)) >= 0;
}

/// depth - a <= high + |high| r at the inverse depth farthest from the viewer.
template <class Number>
bool is_not_too_far(const Number& inverse_depth, const LocalBounds& local, float depth,
                    Projection projection) {
    const Number r(local.depth_relative), a(local.depth_absolute), z{double(depth)}, one(1);
    if (projection == Projection::parallel)
        return sign(-inverse_depth + magnitude(inverse_depth) * r - (z - a)) >= 0;
    return sign(inverse_depth) <= 0 || sign((one + r) - (z - a) * inverse_depth) >= 0;
}

/// Where a renderer keeps to the corners' depths, the admissible interval is clamped to them.
struct CornerLimits {
    bool is_beyond = false;                              ///< the depth is none that such a renderer gives
    bool is_at_farthest = false, is_at_nearest = false;  ///< admissible whatever the plane says on that side
};

CornerLimits corner_limits(const Neighbour& n, double z) {
    const double r = n.bounds.depth_relative, a = n.bounds.depth_absolute;
    return {.is_beyond = !(z >= n.nearest - std::abs(n.nearest) * r - a &&
                           z <= n.farthest + std::abs(n.farthest) * r + a),
            .is_at_farthest = z >= n.farthest - std::abs(n.farthest) * r - a,
            .is_at_nearest = z <= n.nearest + std::abs(n.nearest) * r + a};
}

bool is_admissible_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                         const PixelCoord& place, float depth) {
    const Neighbour n = neighbour_of(ViewRay<double>(view, place.x, place.y), bounds, p_world);
    const Projection projection = view.camera.projection;
    if (!std::isfinite(depth)) return false;
    if (!std::isfinite(n.bounds.depth_relative + n.bounds.depth_absolute + n.bounds.inverse_depth_error))
        return true;
    const CornerLimits limits = bounds.keeps_to_corners() ? corner_limits(n, depth) : CornerLimits{};
    if (limits.is_beyond) return false;
    if (!n.is_plane_known) return true;  // the corners alone say
    const double shift = n.bounds.depth_eps_px * n.gradient + n.bounds.inverse_depth_error;
    const auto decide = [&]<class Number>(Number) {
        const auto image = image_of(ViewRay<Number>(view, place.x, place.y), corners<Number>(p_world));
        if (!image) return true;
        const Number inverse_depth = image->inverse_depth.c + Number(n.bounds.inverse_depth_bias), s(shift);
        return (limits.is_at_farthest ||
                is_not_too_near<Number>(inverse_depth + s, n.bounds, depth, projection)) &&
               (limits.is_at_nearest ||
                is_not_too_far<Number>(inverse_depth - s, n.bounds, depth, projection));
    };
    try {
        return decide(Interval());
    } catch (const UndecidedSign&) {
        return decide(Rational());
    }
}

}  // namespace

DepthCheck check_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                       const TriangleDepth& triangle, const PixelCoord& place, float depth) {
    const DepthBound bound = triangle.at(place.x, place.y);
    return {.bound = bound,
            .error_over_bound = error_over_bound(bound, depth),
            .is_admissible = triangle.certainly_holds(bound, depth) ||
                             is_admissible_depth(view, bounds, p_world, place, depth)};
}

}  // namespace zproof
