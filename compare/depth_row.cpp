#include "compare/depth_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double clamped(double value, double low, double high) {
    const double raised = value < low ? low : value;
    return high < raised ? high : raised;
}

struct Range {
    double low, truth, high;
};

/// What the projections differ in: the depths within `shift` of a nearness, and what our own rounding of the
/// nearness comes to at depth z. Divisions come first and what they give is chosen afterwards, so that the
/// loop has no branches.
struct Perspective {
    static Range range(double nearness, double shift) {
        const double nearer = nearness + shift, farther = nearness - shift;
        const double low = 1 / nearer, truth = 1 / nearness, high = 1 / farther;
        return {nearer > 0 ? low : infinite, nearness > 0 ? truth : infinite, farther > 0 ? high : infinite};
    }
    static double margin(double own_error, double z) { return 2 * own_error * z * z; }
};
struct Parallel {
    static Range range(double nearness, double shift) {
        return {-nearness - shift, -nearness, -nearness + shift};
    }
    static double margin(double own_error, double) { return own_error; }
};

/// The sum of depth's relative errors at a nearness. Most renderers have the same everywhere, and then it
/// costs no division per pixel.
struct Everywhere {
    static double sum(const DepthRow& t, double) { return t.depth_factor; }
};
struct ByNearness {
    static double sum(const DepthRow& t, double nearness) {
        return t.depth_factor + t.plane_offset / nearness;
    }
};

/// `count` pixels from `first_x` on. Inlined into each instruction set's copy of its callers. The row is a
/// copy, so that what is written cannot be any of it, and stays in registers.
template <class Projected, class Relative>
[[gnu::always_inline]] inline void hold_pixels(const DepthRow t, int first_x, int count, const float* depth,
                                               double* ratio) {
    for (int i = 0; i < count; ++i) {
        const double nearness = t.nearness_step * (first_x + i) + t.nearness_row + t.nearness_offset;
        const double here = clamped(nearness, t.least, t.highest);
        const double reach = (t.base + t.per * here) * t.amplification;
        const Range range =
            Projected::range(nearness, (reach < t.most ? reach : t.most) * t.gradient + t.nearness_error);
        const double nearest = clamped(range.low, t.nearest, t.farthest);
        const double farthest = clamped(range.high, t.nearest, t.farthest);
        const double truth = clamped(range.truth, nearest, farthest);
        const double sum = Relative::sum(t, here), relative = sum / (1 - sum);
        const double low = nearest - std::abs(nearest) * relative - t.absolute;
        const double high = farthest + std::abs(farthest) * relative + t.absolute;
        const double z = depth[i], margin = Projected::margin(t.own_error, z),
                     rounding = 8 * unit_roundoff_float64 * z;
        const bool holds = (sum < 1) & (truth < infinite) & (z >= 0) & (low + margin + rounding <= z) &
                           (z <= high - margin - rounding);
        const double error = std::abs(z - truth), room = z < truth ? truth - low : high - truth;
        const double share = error / room;
        ratio[i] = holds ? (error > 0 ? share : 0) : unsettled;
    }
}

/// Four pixels to seven are filled up to one step of the widest vectors: that is faster than one by one.
template <class Projected, class Relative>
[[gnu::always_inline]] inline void hold_row(const DepthRow& row, int first_x, std::span<const float> depth,
                                            double* ratio) {
    constexpr int step = 8;
    const int count = int(depth.size());
    if (count >= step / 2 && count < step) {
        std::array<float, step> depths{};
        std::array<double, step> ratios;
        std::copy_n(depth.data(), count, depths.data());
        hold_pixels<Projected, Relative>(row, first_x, step, depths.data(), ratios.data());
        std::copy_n(ratios.data(), count, ratio);
    } else {
        hold_pixels<Projected, Relative>(row, first_x, count, depth.data(), ratio);
    }
}

}  // namespace

/// Compiled once per instruction set. No bit depends on which runs: contraction is off, and the loop keeps
/// its order.
[[gnu::target_clones("default", "avx2", "avx512f")]] void hold_perspective_row(const DepthRow& row,
                                                                               int first_x,
                                                                               std::span<const float> depth,
                                                                               double* ratio) {
    if (row.plane_offset == 0)
        hold_row<Perspective, Everywhere>(row, first_x, depth, ratio);
    else
        hold_row<Perspective, ByNearness>(row, first_x, depth, ratio);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void hold_parallel_row(const DepthRow& row, int first_x,
                                                                            std::span<const float> depth,
                                                                            double* ratio) {
    if (row.plane_offset == 0)
        hold_row<Parallel, Everywhere>(row, first_x, depth, ratio);
    else
        hold_row<Parallel, ByNearness>(row, first_x, depth, ratio);
}

}  // namespace zproof
