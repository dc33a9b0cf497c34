#include "compare/depth_law.h"

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

/// The sum of depth's relative errors at a nearness. Most renderers have the same everywhere.
struct Everywhere {
    static double sum(double factor, double, double) { return factor; }
};
struct ByNearness {
    static double sum(double factor, double offset, double nearness) { return factor + offset / nearness; }
};
struct Either {
    static double sum(double factor, double offset, double nearness) {
        const double varying = factor + offset / nearness;
        return offset == 0 ? factor : varying;
    }
};

/// A pixel's depth held against its law; no branches, so that neighbours are done side by side.
template <class Projected, class Relative>
[[gnu::always_inline]] inline double ratio_of(const DepthLaw& t, double nearness, double z) {
    const double here = clamped(nearness, t.least, t.highest);
    const double reach = (t.base + t.per * here) * t.amplification;
    const Range range =
        Projected::range(nearness, (reach < t.most ? reach : t.most) * t.gradient + t.nearness_error);
    const double nearest = clamped(range.low, t.nearest, t.farthest);
    const double farthest = clamped(range.high, t.nearest, t.farthest);
    const double truth = clamped(range.truth, nearest, farthest);
    const double sum = Relative::sum(t.depth_factor, t.plane_offset, here), relative = sum / (1 - sum);
    const double low = nearest - std::abs(nearest) * relative - t.absolute;
    const double high = farthest + std::abs(farthest) * relative + t.absolute;
    const double margin = Projected::margin(t.own_error, z), rounding = 8 * unit_roundoff_float64 * z;
    const bool holds = (sum < 1) & (truth < infinite) & (z >= 0) & (low + margin + rounding <= z) &
                       (z <= high - margin - rounding);
    const double error = std::abs(z - truth), room = z < truth ? truth - low : high - truth;
    const double share = error / room;
    return holds ? (error > 0 ? share : 0) : unsettled;
}

/// `count` pixels of one law. It is a copy, so that what is written cannot be any of it, and stays in
/// registers.
template <class Projected, class Relative>
[[gnu::always_inline]] inline void hold_run(const DepthLaw law, const RowOfDepths& row, std::size_t first,
                                            std::size_t count, double* ratio) {
    const double along_row = law.nearness_per_y * row.y;
    const int x = row.x + int(first);
    const float* depth = row.depth + first;
    for (int i = 0; i < int(count); ++i) {
        const double nearness = law.nearness_per_x * (x + i) + along_row + law.nearness_offset;
        ratio[first + std::size_t(i)] = ratio_of<Projected, Relative>(law, nearness, depth[i]);
    }
}

constexpr std::size_t together = RowOfDepths::together;

/// Pixels of several laws.
template <class Projected>
[[gnu::always_inline]] inline void hold_mixed(std::span<const DepthLaw> laws, const RowOfDepths& row,
                                              std::size_t first, double* ratio) {
    const std::uint32_t* which = row.law.data() + first;
    const float* depth = row.depth + first;
    const int x = row.x + int(first);
    double result[together];
    for (int i = 0; i < int(together); ++i) {
        const DepthLaw& law = laws[which[i]];
        const double nearness =
            law.nearness_per_x * (x + i) + law.nearness_per_y * row.y + law.nearness_offset;
        result[i] = ratio_of<Projected, Either>(law, nearness, depth[i]);
    }
    std::copy_n(result, together, ratio + first);
}

/// Pixels from `first` on that share its law, in whole steps.
[[gnu::always_inline]] inline std::size_t steps_of_one_law(std::span<const std::uint32_t> law,
                                                           std::size_t first) {
    std::size_t end = first;
    while (end < law.size()) {
        std::uint32_t difference = 0;
        for (std::size_t i = 0; i < together; ++i) difference |= law[end + i] ^ law[first];
        if (difference != 0) break;
        end += together;
    }
    return end - first;
}

template <class Projected>
[[gnu::always_inline]] inline void hold_row(std::span<const DepthLaw> laws, const RowOfDepths& row,
                                            double* ratio) {
    for (std::size_t first = 0; first < row.law.size();) {
        const std::size_t run = steps_of_one_law(row.law, first);
        const DepthLaw& law = laws[row.law[first]];
        if (run == 0)
            hold_mixed<Projected>(laws, row, first, ratio);
        else if (law.plane_offset == 0)
            hold_run<Projected, Everywhere>(law, row, first, run, ratio);
        else
            hold_run<Projected, ByNearness>(law, row, first, run, ratio);
        first += run == 0 ? together : run;
    }
}

}  // namespace

/// Compiled once per instruction set. No bit depends on which runs: contraction is off, and the loops keep
/// their order.
[[gnu::target_clones("default", "avx2", "avx512f")]] void hold_perspective(std::span<const DepthLaw> laws,
                                                                           const RowOfDepths& row,
                                                                           double* ratio) {
    hold_row<Perspective>(laws, row, ratio);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void hold_parallel(std::span<const DepthLaw> laws,
                                                                        const RowOfDepths& row,
                                                                        double* ratio) {
    hold_row<Parallel>(laws, row, ratio);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void bin_ratios(const PairOfRatios& ratios,
                                                                     const PairOfBins& bins) {
    for (std::size_t first = 0; first < ratios.one.size(); first += together) {
        const double *one = ratios.one.data() + first, *also = ratios.also.data() + first;
        const std::uint32_t* counts = ratios.counts.data() + first;
        std::int32_t bin[together], bin_also[together];
        double most[together], most_also[together];
        for (std::size_t i = 0; i < together; ++i) {
            const bool is_counted = (one[i] >= 0) & (also[i] >= 0) & (counts[i] != 0);
            const double scaled = one[i] * 20 < 20 ? one[i] * 20 : 20;
            const double scaled_also = also[i] * 20 < 20 ? also[i] * 20 : 20;
            bin[i] = is_counted ? std::int32_t(scaled) : unsettled_bin;
            bin_also[i] = is_counted ? std::int32_t(scaled_also) : unsettled_bin;
            const double least = bins.most_of_one[i], least_also = bins.most_of_also[i];
            most[i] = is_counted & (one[i] > least) ? one[i] : least;
            most_also[i] = is_counted & (also[i] > least_also) ? also[i] : least_also;
        }
        std::copy_n(bin, together, bins.one + first);
        std::copy_n(bin_also, together, bins.also + first);
        std::copy_n(most, together, bins.most_of_one);
        std::copy_n(most_also, together, bins.most_of_also);
    }
}

}  // namespace zproof
