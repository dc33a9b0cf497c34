#include "lessons/depth/bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "math/rounding.h"

namespace zproof::study::depth {
namespace {

constexpr double u = unit_roundoff_float32;
constexpr double infinite = std::numeric_limits<double>::infinity();

double g(int roundings) { return gamma(roundings, u); }

/// a + b / d, before the window.
double z_ndc(const Constants& c, double depth) { return c.a + c.b / depth; }

double binary_logarithm(const Constants& c, double depth) { return std::abs(std::log2(depth / c.near)); }

/// Weighted arithmetic over weighted harmonic mean, less 1, is at most this (Kantorovich 1948); geometric
/// means lie between the two.
double excess_of_means(const DepthSample& p) {
    const double difference = p.farthest - p.nearest;
    return difference * difference / (4 * p.nearest * p.farthest);
}

/// The change of s where d changes by a share of itself.
double s_of_share(const Coder& coder, double depth, double share) {
    const Constants& c = coder.constants();
    switch (coder.format().coding) {
        case Coding::z:
        case Coding::reversed:
            return c.half * std::abs(c.b) / depth * share;
        case Coding::w:
            return c.k * depth * share;
        case Coding::logarithmic:
            return c.k * share / std::numbers::ln2;
    }
    return infinite;
}

/// The error from the rounding of a, b, k, n and 1/n.
double common_error(const Coder& coder, double depth) {
    const Constants& c = coder.constants();
    const double s = std::abs(coder.ideal(depth));
    switch (coder.format().coding) {
        case Coding::z:
        case Coding::reversed:
            return c.half * g(1) * (std::abs(c.a) + std::abs(c.b) / depth);
        case Coding::w:
            return g(1) * c.near * c.k + g(1) * s;
        case Coding::logarithmic:
            return c.k * g(1) / std::numbers::ln2 + g(1) * s;
    }
    return infinite;
}

/// The window's sum comes after NDC's last rounding, which then is not the last.
double inner_rounding(const Coder& coder, double depth) {
    const Constants& c = coder.constants();
    return c.half < 1 ? c.half * g(1) * std::abs(z_ndc(c, depth)) : 0;
}

/// The error of a coded corner, from all roundings. log2 of float32 is good to 1 ulp, at most 2u (GNU C
/// Library manual).
double corner_error(const Coder& coder, double depth) {
    const Constants& c = coder.constants();
    const double s = std::abs(coder.ideal(depth));
    switch (coder.format().coding) {
        case Coding::z:
        case Coding::reversed:
            return c.half * (g(2) * std::abs(c.b) / depth + g(2) * std::abs(c.a) +
                             g(3) * std::abs(z_ndc(c, depth))) +
                   (c.half < 1 ? g(1) * s : 0);
        case Coding::w:
            return g(2) * depth * c.k + g(2) * s;
        case Coding::logarithmic:
            return c.k * (g(3) / std::numbers::ln2 + 2 * u * binary_logarithm(c, depth)) + g(1) * s;
    }
    return infinite;
}

/// Each coding is monotone in depth, and so is each term above in |s|, |z| or 1/d: an end decides.
double largest_corner_error(const Coder& coder, const DepthSample& p) {
    return std::max(corner_error(coder, p.nearest), corner_error(coder, p.farthest));
}

double largest_s(const Coder& coder, const DepthSample& p) {
    return std::max(std::abs(coder.ideal(p.nearest)), std::abs(coder.ideal(p.farthest)));
}

/// d is off by `share` before it is coded at the pixel.
double coded_at_pixel(const Coder& coder, double depth, double share) {
    const Constants& c = coder.constants();
    const double carried = s_of_share(coder, depth, share);
    switch (coder.format().coding) {
        case Coding::z:
        case Coding::reversed:
            return carried + inner_rounding(coder, depth);
        case Coding::w:
            return carried + g(1) * std::abs(coder.ideal(depth));
        case Coding::logarithmic:
            return carried + c.k * 2 * u * binary_logarithm(c, depth);
    }
    return infinite;
}

/// 1/d: corner, its reciprocal, weight, product and two sums are 6 roundings; b times it, or 1 / it and the
/// product with 1/n, and what compounding costs are 3 more.
double error_by_reciprocal(const Coder& coder, const DepthSample& p) {
    return coded_at_pixel(coder, p.depth, g(9) + 3 * p.weight_error * p.depth / p.nearest);
}

/// d: corner, weight, product and two sums are 5 roundings; coding a d like a corner's adds that.
double error_by_depth(const Coder& coder, const DepthSample& p) {
    return s_of_share(coder, p.depth, g(6) + 3 * p.weight_error * p.farthest / p.depth) +
           corner_error(coder, p.depth);
}

double error_by_corners(const Coder& coder, const DepthSample& p) {
    const double s = largest_s(coder, p);
    return largest_corner_error(coder, p) + g(4) * s + 3 * p.weight_error * s;
}

/// Every sum rounds what is no larger than `largest`, every step is rounded once. The start and both steps
/// are made of barycentrics, hence 12 weights in all.
double error_by_steps(const Coder& coder, const DepthSample& p) {
    return largest_corner_error(coder, p) + g(p.across + p.down + 2) * p.largest +
           g(1) * (p.across * std::abs(p.per_x) + p.down * std::abs(p.per_y)) +
           12 * p.weight_error * std::max(p.largest, largest_s(coder, p));
}

double own_error(const Coder& coder, Interpolation interpolation, const DepthSample& p) {
    switch (interpolation) {
        case Interpolation::reciprocal:
            return error_by_reciprocal(coder, p);
        case Interpolation::ndc:
            return error_by_corners(coder, p);
        case Interpolation::forward:
            return error_by_steps(coder, p);
        case Interpolation::affine:
            return error_by_depth(coder, p);
    }
    return infinite;
}

/// The distance between neighbours in the store, at values up to s.
double step_of(Store store, double s) {
    switch (store) {
        case Store::float32:
            return s > 0 ? std::ldexp(1.0, std::max(std::ilogb(s), -126) - 23) : 0;
        case Store::unorm24:
        case Store::unorm16:
            return 1 / (std::ldexp(1.0, bits_of(store)) - 1);
    }
    return infinite;
}

DepthSample place_around(double depth, double spread) {
    return {.depth = depth, .nearest = depth / spread, .farthest = depth * spread};
}

/// The difference in s from which on two layers at these depths keep their order: a step of the store, and
/// both errors. The last rounding to float32 is monotone, so it costs a float32 buffer no more than its step.
double certain_difference(const Coder& coder, Interpolation interpolation, const DepthSample& one,
                          const DepthSample& other) {
    const double s = std::max(std::abs(coder.ideal(one.depth)), std::abs(coder.ideal(other.depth)));
    const ErrorOfS a = error_of_s(coder, interpolation, one), b = error_of_s(coder, interpolation, other);
    const bool is_float = coder.format().store == Store::float32;
    const double lasts = is_float ? 0 : a.last + b.last;
    // The constants' rounding scales all differences by 1 + u at most.
    return (step_of(coder.format().store, s) + a.own + b.own + lasts) * (1 + g(2));
}

enum class GapSide { behind, before };

/// The depth where s has changed by `difference`; infinite where that is beyond the planes.
double moved(const Coder& coder, double depth, double difference, GapSide side) {
    const bool s_grows = (side == GapSide::behind) == grows_with_depth(coder.format().coding);
    const double s = coder.ideal(depth) + (s_grows ? difference : -difference);
    if (s < 0 || s > 1) return infinite;
    return coder.depth_of(s);
}

/// The other layer's depth decides its own error, so the difference is worked out again where it led to: each
/// round corrects the one before by a share of the order of u.
double smallest_gap(const Coder& coder, Interpolation interpolation, const DepthSample& here, GapSide side) {
    const double spread = here.depth / here.nearest;
    double there = here.depth;
    for (int round = 0; round < 4 && std::isfinite(there); ++round)
        there = moved(coder, here.depth,
                      certain_difference(coder, interpolation, here, place_around(there, spread)), side);
    return std::abs(there - here.depth);
}

}  // namespace

double weight_error_of(const Drawn& triangle, double reach_px) {
    const auto& p = triangle.p_raster;
    const double longest =
        std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
    return 8 * 0x1p-48 * reach_px * longest / std::abs(triangle.doubled_area());
}

ErrorOfS error_of_s(const Coder& coder, Interpolation interpolation, const DepthSample& p) {
    const bool is_right = is_right_for(interpolation, coder.format().coding);
    return {.common = std::max(common_error(coder, p.nearest), common_error(coder, p.farthest)),
            .own = own_error(coder, interpolation, p),
            .last = g(1) * std::abs(coder.ideal(p.depth)),
            .systematic = is_right ? 0 : s_of_share(coder, p.depth, excess_of_means(p))};
}

double depth_bound(const Coder& coder, Interpolation interpolation, const DepthSample& p) {
    const ErrorOfS e = error_of_s(coder, interpolation, p);
    const Store store = coder.format().store;
    const double storing = store == Store::float32 ? 0 : step_of(store, 1) / 2;
    const Constants& c = coder.constants();
    // Ours: the formulas in double, 8 roundings.
    const double formula = gamma(8, unit_roundoff_float64) * (std::abs(c.a) + std::abs(c.b) / p.depth + 2);
    const double error = e.common + e.own + e.systematic + e.last * (1 + g(1)) + storing + formula;
    const double s = coder.ideal(p.depth);
    const auto off = [&](double at) { return std::abs(coder.depth_of(std::clamp(at, 0.0, 1.0)) - p.depth); };
    return std::max(off(s - error), off(s + error));
}

double smallest_gap_behind(const Coder& coder, Interpolation interpolation, double depth, double spread) {
    return smallest_gap(coder, interpolation, place_around(depth, spread), GapSide::behind);
}

double smallest_gap_before(const Coder& coder, Interpolation interpolation, double depth, double spread) {
    return smallest_gap(coder, interpolation, place_around(depth, spread), GapSide::before);
}

double worst_gap(const Format& format, const Planes& planes) {
    if (!can_hold(format.coding, planes)) return infinite;
    const Coder coder{format, planes};
    double worst = 0;
    for (int i = 0; i <= 256; ++i) {
        const double depth = planes.near * std::pow(planes.far / planes.near, i / 256.0);
        const double gap = smallest_gap_before(coder, Interpolation::reciprocal, depth);
        // Before near there is nothing to be told from: what lies there is too close to near, not to this.
        worst = std::max(worst, std::isfinite(gap) ? gap : depth - planes.near);
    }
    return worst;
}

}  // namespace zproof::study::depth
