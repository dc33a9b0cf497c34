#include "compare/admissible/depth_rule.h"

#include <cmath>

#include "math/interval.h"
#include "math/rational.h"

namespace zproof {

namespace {

/// depth + a >= low - |low| r at the nearness closest to the viewer, without division by nearness.
template <class Number>
bool is_not_too_near(const Number& nearness, const LocalBounds& local, float depth, Projection projection) {
    const Number r(local.depth_relative), a(local.depth_absolute), z{double(depth)}, one(1);
    if (projection == Projection::parallel) return sign((z + a) - (-nearness - magnitude(nearness) * r)) >= 0;
    return sign(nearness) > 0 && sign((z + a) * nearness - (one - r)) >= 0;
}

/// depth - a <= high + |high| r at the nearness farthest from the viewer.
template <class Number>
bool is_not_too_far(const Number& nearness, const LocalBounds& local, float depth, Projection projection) {
    const Number r(local.depth_relative), a(local.depth_absolute), z{double(depth)}, one(1);
    if (projection == Projection::parallel) return sign(-nearness + magnitude(nearness) * r - (z - a)) >= 0;
    return sign(nearness) <= 0 || sign((one + r) - (z - a) * nearness) >= 0;
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
                         const PixelPlace& place, float depth) {
    const Neighbour n = neighbour_of(Sight<double>(view, place.x, place.y), bounds, p_world);
    const Projection projection = view.camera.projection;
    if (!std::isfinite(depth)) return false;
    if (!std::isfinite(n.bounds.depth_relative + n.bounds.depth_absolute + n.bounds.nearness_error))
        return true;
    const CornerLimits limits = bounds.keeps_to_corners() ? corner_limits(n, depth) : CornerLimits{};
    if (limits.is_beyond) return false;
    if (!n.is_plane_known) return true;  // the corners alone say
    const double shift = n.bounds.depth_eps_px * n.gradient + n.bounds.nearness_error;
    const auto decide = [&]<class Number>(Number) {
        const auto image = image_of(Sight<Number>(view, place.x, place.y), corners<Number>(p_world));
        if (!image) return true;
        const Number nearness = image->nearness.c, s(shift);
        return (limits.is_at_farthest ||
                is_not_too_near<Number>(nearness + s, n.bounds, depth, projection)) &&
               (limits.is_at_nearest || is_not_too_far<Number>(nearness - s, n.bounds, depth, projection));
    };
    try {
        return decide(Interval());
    } catch (const UndecidedSign&) {
        return decide(Rational());
    }
}

}  // namespace

DepthCheck check_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                       const TriangleDepth& triangle, const PixelPlace& place, float depth) {
    const DepthBound bound = triangle.at(place.x, place.y);
    return {.bound = bound,
            .error_over_bound = error_over_bound(bound, depth),
            .is_admissible = triangle.certainly_holds(bound, depth) ||
                             is_admissible_depth(view, bounds, p_world, place, depth)};
}

}  // namespace zproof
