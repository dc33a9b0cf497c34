#include "compare/admissible/depth_rule.h"

#include <cmath>
#include <limits>

#include "math/interval.h"
#include "math/rational.h"
#include "math/rounding.h"

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

/// What the corners' depths say, by themselves, of a depth between them.
struct CornerLimits {
    bool is_beyond = false;                              ///< it is none that a mean of them may be
    bool is_at_farthest = false, is_at_nearest = false;  ///< admissible whatever the plane says on that side
};

CornerLimits corner_limits(const Neighbour& n, Projection projection, double z) {
    const double r = n.bounds.depth_relative, a = n.bounds.depth_absolute, e = n.bounds.inverse_depth_error;
    const bool perspective = projection == Projection::perspective;
    const double nearest = perspective ? n.nearest / (1 + e * n.nearest) : n.nearest - e;
    const double share = 1 - e * n.farthest, beyond = share > 0 ? n.farthest / share : unlimited;
    const double farthest = perspective ? beyond : n.farthest + e;
    return {.is_beyond =
                !(z >= nearest - std::abs(nearest) * r - a && z <= farthest + std::abs(farthest) * r + a),
            .is_at_farthest = z >= n.farthest - std::abs(n.farthest) * r - a,
            .is_at_nearest = z <= n.nearest + std::abs(n.nearest) * r + a};
}

/// May a pixel that is cut by near and far show this depth, which nothing else bounds?
bool is_between_planes(const Camera& camera, const ViewBounds& bounds, const Neighbour& n, double z) {
    if ((z < 0 && camera.projection == Projection::perspective) || !bounds.can_be_stored(z)) return false;
    // a plane, a distance, where it begins, and their sum are rounded before they are compared
    const double rounding = gamma(4, unit_roundoff_float32), near = bounds.near_depth(),
                 far = camera.far_depth, room = bounds.step_room(z);
    return !bounds.cuts_by_depth() ||
           (z + room >= near - std::min(n.near_slack, rounding * std::abs(near)) &&
            z - room <= far + std::min(n.far_slack, rounding * (std::abs(near) + std::abs(far))));
}

bool is_admissible_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                         const PixelCoord& place, float depth) {
    const Neighbour n = neighbour_of(ViewRay<double>(view, place.x, place.y), bounds, p_world);
    const Projection projection = view.camera.projection;
    if (!(depth >= std::numeric_limits<float>::lowest())) return false;  // NaN, or -infinity
    if (!std::isfinite(n.bounds.depth_relative + n.bounds.depth_absolute + n.bounds.inverse_depth_error))
        return is_between_planes(view.camera, bounds, n, depth);
    const CornerLimits of_corners = corner_limits(n, projection, depth);
    const CornerLimits limits = bounds.keeps_to_corners() ? of_corners : CornerLimits{};
    if (limits.is_beyond) return false;
    if (!n.is_plane_known && bounds.keeps_to_corners()) return true;  // the corners alone say
    const auto decide = [&]<class Number>(Number) {
        const auto image = image_of(ViewRay<Number>(view, place.x, place.y), corners<Number>(p_world));
        if (!image)
            return !of_corners.is_beyond;  // edge-on: any renderer that draws it shows a mean of its corners
        const Affine<Number>& plane = image->inverse_depth;
        const Number inverse_depth = plane.c + Number(n.bounds.inverse_depth_bias);
        const Number s = Number(n.bounds.depth_eps_px) * (magnitude(plane.a) + magnitude(plane.b)) +
                         Number(n.bounds.inverse_depth_error);
        if (std::isinf(depth)) return projection == Projection::perspective && sign(inverse_depth - s) <= 0;
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
                             (!triangle.certainly_refuses(bound, depth) &&
                              is_admissible_depth(view, bounds, p_world, place, depth))};
}

}  // namespace zproof
