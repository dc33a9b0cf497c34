#include "compare/truth/depth_bound.h"

#include <algorithm>
#include <cmath>

#include "math/interval.h"
#include "math/rational.h"
#include "math/rounding.h"

namespace zproof {

namespace {

/// The depths that lie within `shift` of the nearness, before rounding: [low, high].
struct DepthRange {
    double low, high;
};

DepthRange shifted(double nearness, double shift, bool perspective) {
    if (!perspective) return {-nearness - shift, -nearness + shift};
    const double nearer = nearness + shift, farther = nearness - shift;
    return {nearer > 0 ? 1 / nearer : unlimited, farther > 0 ? 1 / farther : unlimited};
}

DepthBound with_rounding(DepthRange range, double truth, const LocalBounds& local) {
    const double r = local.depth_relative, a = local.depth_absolute;
    if (!std::isfinite(r + a + local.nearness_error)) return {0, truth, unlimited};
    // beyond the plane's horizon no depth is near enough
    const double low = std::isinf(range.low) ? range.low : range.low - std::abs(range.low) * r - a;
    return {low, truth, range.high + std::abs(range.high) * r + a};
}

/// depth + a >= low - |low| r at the nearness closest to the viewer, without division by nearness.
template <class Number>
bool is_not_too_near(const Number& nearness, const LocalBounds& local, float depth, bool perspective) {
    const Number r(local.depth_relative), a(local.depth_absolute), z{double(depth)}, one(1);
    if (!perspective) return sign((z + a) - (-nearness - magnitude(nearness) * r)) >= 0;
    return sign(nearness) > 0 && sign((z + a) * nearness - (one - r)) >= 0;
}

/// depth - a <= high + |high| r at the nearness farthest from the viewer.
template <class Number>
bool is_not_too_far(const Number& nearness, const LocalBounds& local, float depth, bool perspective) {
    const Number r(local.depth_relative), a(local.depth_absolute), z{double(depth)}, one(1);
    if (!perspective) return sign(-nearness + magnitude(nearness) * r - (z - a)) >= 0;
    return sign(nearness) <= 0 || sign((one + r) - (z - a) * nearness) >= 0;
}

/// Where a renderer keeps to the corners' depths, the lawful interval is clamped to them.
struct CornerLimits {
    bool is_beyond = false;                              ///< the depth is none that such a renderer gives
    bool is_at_farthest = false, is_at_nearest = false;  ///< lawful whatever the plane says on that side
};

CornerLimits corner_limits(const Neighbour& n, double z) {
    const double r = n.bounds.depth_relative, a = n.bounds.depth_absolute;
    return {.is_beyond = !(z >= n.nearest - std::abs(n.nearest) * r - a &&
                           z <= n.farthest + std::abs(n.farthest) * r + a),
            .is_at_farthest = z >= n.farthest - std::abs(n.farthest) * r - a,
            .is_at_nearest = z <= n.nearest + std::abs(n.nearest) * r + a};
}

}  // namespace

TriangleNearness::TriangleNearness(const Sight<double>& first_pixel, const Resolution& size,
                                   const TriangleExtent& extent, const CornersWorld& p_world)
    : perspective(first_pixel.projection == Projection::perspective) {
    const auto plane = nearness_of(first_pixel, corners<double>(p_world));
    edge_on = !plane;
    if (edge_on) return;
    nearness = *plane;
    gradient = std::abs(nearness.a) + std::abs(nearness.b);
    own_error = own_error_of(extent.size.plane, nearness, size);
}

TriangleDepth::TriangleDepth(const TriangleNearness& nearness, const TriangleBounds& bounds,
                             bool keeps_to_corners)
    : plane_(nearness),
      bounds_(bounds, nearness.gradient),
      nearest_(bounds.nearest),
      farthest_(bounds.farthest),
      keeps_to_corners_(keeps_to_corners) {}

DepthBound TriangleDepth::at(int x, int y) const {
    const double nearness = plane_.nearness.at(x, y);
    const LocalBounds local = bounds_.at(nearness);
    if (plane_.edge_on || !std::isfinite(plane_.own_error))
        return with_rounding({nearest_, farthest_}, nearest_, local);
    const double shift = local.depth_eps_px * plane_.gradient + local.nearness_error;
    DepthRange range = shifted(nearness, shift, plane_.perspective);
    double truth = !plane_.perspective ? -nearness : nearness > 0 ? 1 / nearness : unlimited;
    if (keeps_to_corners_) {
        range = {std::clamp(range.low, nearest_, farthest_), std::clamp(range.high, nearest_, farthest_)};
        truth = std::clamp(truth, range.low, range.high);
    }
    return with_rounding(range, truth, local);
}

TriangleDepth depth_of(const TriangleInView& triangle, const ViewBounds& bounds) {
    return {triangle.nearness, bounds.of_depth(triangle.extent), bounds.keeps_to_corners()};
}

DepthLaw depth_law_of(const TriangleInView& triangle, const ViewBounds& of_view) {
    const TriangleNearness& plane = triangle.nearness;
    if (plane.edge_on) return law_of_nothing;
    const TriangleBounds bounds = of_view.of_depth(triangle.extent);
    return law_of<double>({.nearness = plane.nearness,
                           .gradient = plane.gradient,
                           .own_error = plane.own_error,
                           .nearest = bounds.nearest,
                           .farthest = bounds.farthest},
                          {.eps_base_px = bounds.depth_eps_base_px,
                           .eps_per_nearness = bounds.depth_eps_per_nearness,
                           .factor = bounds.depth_factor,
                           .absolute = bounds.depth_absolute,
                           .nearness_error = bounds.nearness_error,
                           .plane_offset = bounds.plane_offset},
                          of_view.keeps_to_corners() ? KeepsToCorners::yes : KeepsToCorners::no);
}

bool is_lawful_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world,
                     const PixelPlace& place, float depth) {
    const Neighbour n = neighbour_of(Sight<double>(view, place.x, place.y), bounds, p_world);
    const bool perspective = view.camera.projection == Projection::perspective;
    const double z = depth, r = n.bounds.depth_relative, a = n.bounds.depth_absolute;
    if (!std::isfinite(z)) return false;
    if (!std::isfinite(r + a + n.bounds.nearness_error)) return true;
    const CornerLimits limits = bounds.keeps_to_corners() ? corner_limits(n, z) : CornerLimits{};
    if (limits.is_beyond) return false;
    if (!n.is_plane_known) return true;  // the corners alone say
    const double shift = n.bounds.depth_eps_px * n.gradient + n.bounds.nearness_error;
    const auto decide = [&]<class Number>(Number) {
        const auto image = image_of(Sight<Number>(view, place.x, place.y), corners<Number>(p_world));
        if (!image) return true;
        const Number nearness = image->nearness.c, s(shift);
        return (limits.is_at_farthest ||
                is_not_too_near<Number>(nearness + s, n.bounds, depth, perspective)) &&
               (limits.is_at_nearest || is_not_too_far<Number>(nearness - s, n.bounds, depth, perspective));
    };
    try {
        return decide(Interval());
    } catch (const UndecidedSign&) {
        return decide(Rational());
    }
}

}  // namespace zproof
