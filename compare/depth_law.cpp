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

struct Pixel {
    int x, y;
};

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

/// A depth's bound, and its error over that.
struct Held {
    double low, truth, high, ratio;
};

/// A pixel's depth held against its law; no branches, so that neighbours are done side by side.
template <class Projected, class Relative>
[[gnu::always_inline]] inline Held held(const DepthLaw& t, double nearness, double z) {
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
    return {low, truth, high, holds ? (error > 0 ? share : 0) : unsettled};
}

/// Pixels [first, end) of one law. It is a copy, so that what is written cannot be any of it, and stays in
/// registers.
template <class Projected, class Relative>
[[gnu::always_inline]] inline void hold_run(const DepthLaw law, const Pixel& origin, std::size_t first,
                                            std::size_t end, Strip::Side& side) {
    const double along_column = law.nearness_per_y * origin.y;
    const int x = origin.x + int(first), count = int(end - first);
    const float* depth = side.camera_depth.data() + first;
    double* ratio = side.ratio.data() + first;
    for (int i = 0; i < count; ++i) {
        const double nearness = law.nearness_per_x * (x + i) + along_column + law.nearness_offset;
        ratio[i] = held<Projected, Relative>(law, nearness, depth[i]).ratio;
    }
}

constexpr std::size_t together = 8;
static_assert(Strip::width % together == 0 && std::tuple_size_v<Largest> == together);

/// `together` pixels of several laws.
template <class Projected>
[[gnu::always_inline]] inline void hold_mixed(const DepthLaw* laws, const Pixel& origin, std::size_t first,
                                              Strip::Side& side) {
    const std::uint32_t* which = side.law.data() + first;
    const float* depth = side.camera_depth.data() + first;
    const int x = origin.x + int(first);
    double ratio[together];
    for (int i = 0; i < int(together); ++i) {
        const DepthLaw& law = laws[which[i]];
        const double nearness =
            law.nearness_per_x * (x + i) + law.nearness_per_y * origin.y + law.nearness_offset;
        ratio[i] = held<Projected, Either>(law, nearness, depth[i]).ratio;
    }
    std::copy_n(ratio, together, side.ratio.data() + first);
}

/// The end of the pixels from `first` on that share its law, in whole steps.
[[gnu::always_inline]] inline std::size_t end_of_law(const Strip::Values<std::uint32_t>& law,
                                                     std::size_t first) {
    std::size_t end = first;
    for (; end < Strip::width; end += together) {
        std::uint32_t difference = 0;
        for (std::size_t i = 0; i < together; ++i) difference |= law[end + i] ^ law[first];
        if (difference != 0) break;
    }
    return end;
}

template <class Projected>
[[gnu::always_inline]] inline void hold_strip(std::span<const DepthLaw> laws, const Pixel& origin,
                                              Strip::Side& side) {
    for (std::size_t first = 0; first < Strip::width;) {
        const std::size_t end = end_of_law(side.law, first);
        const std::uint32_t which = side.law[first];
        if (end == first)
            hold_mixed<Projected>(laws.data(), origin, first, side);
        else if (which == 0)
            std::fill(side.ratio.begin() + first, side.ratio.begin() + end, unsettled);
        else if (laws[which].plane_offset == 0)
            hold_run<Projected, Everywhere>(laws[which], origin, first, end, side);
        else
            hold_run<Projected, ByNearness>(laws[which], origin, first, end, side);
        first = std::max(end, first + together);
    }
}

template <class Projected>
[[gnu::always_inline]] inline DepthRow hold_row(const DepthLaw& law, const RowPlace& at,
                                                const TileRowOf<float>& depth) {
    const double along_column = law.nearness_per_y * at.y;
    DepthRow row;
    for (int i = 0; i < int(tile_columns); ++i) {
        const double nearness = law.nearness_per_x * (at.left + i) + along_column + law.nearness_offset;
        const Held here = held<Projected, Either>(law, nearness, depth[std::size_t(i)]);
        row.low[std::size_t(i)] = here.low;
        row.truth[std::size_t(i)] = here.truth;
        row.high[std::size_t(i)] = here.high;
        row.ratio[std::size_t(i)] = here.ratio;
    }
    return row;
}

/// 0 to 20.
[[gnu::always_inline]] inline std::int32_t bin_of(double ratio) {
    const double scaled = ratio * 20;
    return std::int32_t(scaled < 20 ? scaled : 20);
}

}  // namespace

/// Compiled once per instruction set. No bit depends on which runs: contraction is off, and the loops keep
/// their order.
[[gnu::target_clones("default", "avx2", "avx512f")]] void hold_perspective(std::span<const DepthLaw> laws,
                                                                           int x, int y, Strip::Side& side) {
    hold_strip<Perspective>(laws, {x, y}, side);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void hold_parallel(std::span<const DepthLaw> laws, int x,
                                                                        int y, Strip::Side& side) {
    hold_strip<Parallel>(laws, {x, y}, side);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] DepthRow depths_in_row(
    const DepthLaw& law, Projection projection, const RowPlace& row, const TileRowOf<float>& camera_depth) {
    return projection == Projection::perspective ? hold_row<Perspective>(law, row, camera_depth)
                                                 : hold_row<Parallel>(law, row, camera_depth);
}

[[gnu::target_clones("default", "avx2", "avx512f")]] void sort_out(Strip& strip, Largest& candidate,
                                                                   Largest& reference) {
    constexpr float none = std::numeric_limits<float>::infinity();
    Strip::Side &ours = strip.candidate, &theirs = strip.reference;
    Largest most = candidate, most_of_theirs = reference;
    for (std::size_t first = 0; first < Strip::width; first += together)
        for (std::size_t lane = 0; lane < together; ++lane) {
            const std::size_t i = first + lane;
            const double a = ours.ratio[i], b = theirs.ratio[i];
            const bool agree = ours.primitive[i] == theirs.primitive[i];
            const bool is_counted = agree & (a >= 0) & (b >= 0);
            const bool is_bare = agree & (ours.primitive[i] == PrimitiveId::none) &
                                 (ours.camera_depth[i] == none) & (theirs.camera_depth[i] == none);
            ours.bin[i] = is_counted ? bin_of(a) : Strip::uncounted;
            theirs.bin[i] = is_counted ? bin_of(b) : Strip::uncounted;
            strip.is_open[i] = !(is_counted | is_bare);
            most[lane] = is_counted & (a > most[lane]) ? a : most[lane];
            most_of_theirs[lane] = is_counted & (b > most_of_theirs[lane]) ? b : most_of_theirs[lane];
        }
    candidate = most;
    reference = most_of_theirs;
}

}  // namespace zproof
