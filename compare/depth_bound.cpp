#include "compare/depth_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/interval.h"
#include "math/rational.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

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
    return {range.low - std::abs(range.low) * r - a, truth, range.high + std::abs(range.high) * r + a};
}

/// (depth + a) >= low (1 - r) and (depth - a) <= high (1 + r), without division by nearness.
template <class Number>
bool within(const Number& nearness, const LocalBounds& local, double shift, float depth, bool perspective) {
    const Number r(local.depth_relative), a(local.depth_absolute), z{double(depth)}, s(shift), one(1);
    if (!perspective) {
        const Number low = -nearness - s, high = -nearness + s;  // either may be negative
        const Number lowest = low * (sign(low) < 0 ? one + r : one - r);
        const Number highest = high * (sign(high) < 0 ? one - r : one + r);
        return sign((z + a) - lowest) >= 0 && sign(highest - (z - a)) >= 0;
    }
    const Number nearer = nearness + s, farther = nearness - s;
    if (sign(nearer) <= 0) return false;
    const bool not_too_near = sign((z + a) * nearer - (one - r)) >= 0;
    return not_too_near && (sign(farther) <= 0 || sign((one + r) - (z - a) * farther) >= 0);
}

}  // namespace

TriangleDepth::TriangleDepth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world)
    : perspective_(view.camera.projection == Projection::perspective),
      keeps_to_corners_(bounds.keeps_to_corners()),
      bounds_(bounds.of(p_world)) {
    set_nearness(view, p_world);
}

void TriangleDepth::set_nearness(const View& view, const CornersWorld& p_world) {
    const Sight<double> sight(view, 0, 0);
    const auto image = image_of(sight, corners<double>(p_world));
    edge_on_ = !image;
    if (edge_on_) return;
    nearness_ = image->nearness;
    gradient_ = std::abs(nearness_.a) + std::abs(nearness_.b);
    // nearness = (normal . direction) / volume: absolute sums of both, 16 roundings at most in each
    const PlaneSize size = bounds_.plane_size;
    const double u = gamma(16, unit_roundoff_float64);
    const double largest =
        std::abs(nearness_.c) + std::abs(nearness_.a) * view.width + std::abs(nearness_.b) * view.height;
    const double condition = size.volume_abs / size.volume;
    own_error_ =
        u * condition < 0.5 ? 2 * u * (size.numerator_abs / size.volume + largest * condition) : unlimited;
}

DepthBound TriangleDepth::at(int x, int y) const {
    const double nearness = nearness_.at(x, y);
    const LocalBounds local = bounds_.at(nearness, gradient_);
    if (edge_on_ || !std::isfinite(own_error_))
        return with_rounding({bounds_.nearest, bounds_.farthest}, bounds_.nearest, local);
    DepthRange range = shifted(nearness, local.depth_eps_px * gradient_, perspective_);
    double truth = perspective_ ? 1 / nearness : -nearness;
    if (keeps_to_corners_) {
        range = {std::clamp(range.low, bounds_.nearest, bounds_.farthest),
                 std::clamp(range.high, bounds_.nearest, bounds_.farthest)};
        truth = std::clamp(nearness > 0 || !perspective_ ? truth : unlimited, range.low, range.high);
    }
    return with_rounding(range, truth, local);
}

bool TriangleDepth::certainly_holds(const DepthBound& bound, float depth) const {
    const double z = depth, size = std::abs(z);
    if (edge_on_) return bound.low <= z && z <= bound.high;
    const double relative = perspective_ ? own_error_ * size : 0, absolute = perspective_ ? 0 : own_error_;
    const double margin = 2 * relative * size + absolute + 8 * unit_roundoff_float64 * size;
    return bound.low + margin <= z && z <= bound.high - margin;
}

bool is_lawful_depth(const View& view, const ViewBounds& bounds, const CornersWorld& p_world, int x, int y,
                     float depth) {
    if (!std::isfinite(depth)) return false;
    const Neighbour n = neighbour_of(Sight<double>(view, x, y), bounds, p_world);
    const bool perspective = view.camera.projection == Projection::perspective;
    const double z = depth, r = n.bounds.depth_relative, a = n.bounds.depth_absolute;
    const auto decide = [&]<class Number>(Number) {
        const auto image = image_of(Sight<Number>(view, x, y), corners<Number>(p_world));
        if (!image) return true;  // edge-on: its corners alone say
        return within(image->nearness.c, n.bounds, n.bounds.depth_eps_px * n.gradient, depth, perspective);
    };
    if (bounds.keeps_to_corners() && !(z >= n.nearest * (1 - r) - a && z <= n.farthest * (1 + r) + a))
        return false;
    if (!std::isfinite(r) || !std::isfinite(a)) return true;  // nothing bounds it
    try {
        return decide(Interval());
    } catch (const UndecidedSign&) {
        return decide(Rational());
    }
}

double error_over_bound(const DepthBound& bound, float depth) {
    const double error = std::abs(depth - bound.truth);
    if (error == 0) return 0;
    return error / (depth < bound.truth ? bound.truth - bound.low : bound.high - bound.truth);
}

}  // namespace zproof
