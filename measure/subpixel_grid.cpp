#include <algorithm>
#include <cmath>

#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

constexpr int cell_length = 16, cell_height = 8;  ///< px
constexpr int cells_across = 4, cells_along = 16;
constexpr int corner_rise = 4;  ///< px; how far the moving corner goes
constexpr int watched_row = 1;  ///< of the cell: where the edge is watched

/// An edge from the fixed corner of its cell to a moving corner `length` px across. It passes the
/// sample of the watched pixel when the moving corner passes `threshold`, so that one corner's place is read
/// at a place of our choice.
struct ProbeEdge {
    int across = 0, along = 0;  ///< fixed corner
    int length = 0, pixel = 0;  ///< px from the fixed corner
    double threshold = 0;       ///< raster coordinate of the moving corner
};

/// A threshold on a coarse grid would leave the answer to the fill rule.
bool is_on_a_grid(double threshold) {
    const double steps = threshold * 0x1p24;
    return steps == std::floor(steps);
}

/// Probe edges of every length that fits, watched at every pixel of their outer half: thresholds scattered
/// over the pixel without order.
std::vector<ProbeEdge> probe_edges(double sample_along, double sample_across) {
    std::vector<ProbeEdge> all;
    for (int length = 5; length < cell_length; ++length) {
        for (int pixel = (length + 1) / 2; pixel < length; ++pixel) {
            const auto i = int(all.size());
            if (i == cells_across * cells_along) return all;
            ProbeEdge probe_edge{cell_length * (i % cells_across), cell_height * (i / cells_across), length,
                                 pixel, 0};
            probe_edge.threshold =
                probe_edge.along + (watched_row + sample_along) * length / (pixel + sample_across);
            if (!is_on_a_grid(probe_edge.threshold)) all.push_back(probe_edge);
        }
    }
    return all;
}

Probe probe_of(const ProbeEdge& probe_edge, Axis axis) {
    const double across = probe_edge.across, along = probe_edge.along;
    return {.low = float(along),
            .high = float(along + corner_rise),
            .draw =
                [=](Scene& scene, float place) {
                    add_triangle(scene, axis,
                                 {{{along, across},
                                   {place, across + probe_edge.length},
                                   {along + cell_height, across + probe_edge.length}}});
                },
            .answer =
                [=](const Frame& frame) {
                    return is_covered(frame, axis, probe_edge.along + watched_row,
                                      probe_edge.across + probe_edge.pixel);
                }};
}

/// The part of a grid step that holds all readings: the shortest arc of a circle whose circumference is the
/// step.
struct Arc {
    double start = 0, length = 0;
    double middle(double circumference) const { return std::fmod(start + length / 2, circumference); }
};

Arc arc_of(const std::vector<Flip>& flips, double step) {
    std::vector<double> rests;
    for (const Flip& flip : flips) rests.push_back(std::fmod(double(flip.low), step));
    std::ranges::sort(rests);
    Arc arc{rests.front(), rests.back() - rests.front()};
    for (std::size_t i = 1; i < rests.size(); ++i) {
        const double around = step - (rests[i] - rests[i - 1]);
        if (around < arc.length) arc = {rests[i], around};
    }
    return arc;
}

double widest(const std::vector<Flip>& flips) {
    double width = 0;
    for (const Flip& flip : flips) width = std::max(width, double(flip.high) - double(flip.low));
    return width;
}

/// The coarsest grid, in powers of two, on which the flips lie: they keep to less than half a step. On a grid
/// twice too coarse they would have two places half a step apart. 0 if there is none.
double coarsest_step(const std::vector<Flip>& flips, double finest_px) {
    for (double step = 1; step >= finest_px; step /= 2) {
        if (arc_of(flips, step).length + widest(flips) < step / 2) return step;
    }
    return 0;
}

/// The first and the last flip are a whole number of steps apart, which says most precisely how long one is.
Bracket refined(double step, const std::vector<Flip>& flips) {
    const auto [first, last] = std::ranges::minmax_element(flips, {}, &Flip::low);
    const double count = std::round((double(last->low) - double(first->low)) / step);
    return {(double(last->low) - double(first->high)) / count,
            (double(last->high) - double(first->low)) / count};
}

/// Flips fall half-way between grid lines where vertices go to the nearest, on the lines where they do not;
/// beyond the threshold where they go to the smaller line, before it where they go to the greater.
SnapRounding snap_rounding(const std::vector<Flip>& flips, const std::vector<ProbeEdge>& probe_edges,
                           double step) {
    const Arc arc = arc_of(flips, step);
    const double phase = arc.middle(step);
    if (std::abs(phase - step / 2) < step / 4) return SnapRounding::nearest;
    double beyond = 0;
    for (std::size_t i = 0; i < flips.size(); ++i) beyond += double(flips[i].high) - probe_edges[i].threshold;
    return beyond > 0 ? SnapRounding::towards_smaller : SnapRounding::towards_greater;
}

/// A tie that still says yes (Flip::low) went to the smaller line, one that says no to the greater.
TieRounding tie_rounding(const std::vector<Flip>& flips, double step) {
    std::array<std::array<int, 2>, 2> count{};  // [is the smaller line odd][went to the greater line]
    for (const Flip& flip : flips) {
        for (const bool greater : {false, true}) {
            const double in_steps = double(greater ? flip.high : flip.low) / step - 0.5;
            if (in_steps == std::floor(in_steps)) ++count[std::fmod(in_steps, 2) != 0][greater];
        }
    }
    const auto [even, odd] = count;
    if (even[0] && !even[1] && !odd[0] && odd[1]) return TieRounding::to_even;
    if (even[0] && !even[1] && odd[0] && !odd[1]) return TieRounding::towards_smaller;
    if (!even[0] && even[1] && !odd[0] && odd[1]) return TieRounding::towards_greater;
    return TieRounding::unclear;
}

/// Just before the flip the vertex was drawn at or before the threshold, just after it behind.
Bracket shifts_seen(const std::vector<Flip>& flips, const std::vector<ProbeEdge>& probe_edges) {
    Bracket seen{0, 0};
    for (std::size_t i = 0; i < flips.size(); ++i) {
        seen.low = std::min(seen.low, probe_edges[i].threshold - double(flips[i].low));
        seen.high = std::max(seen.high, probe_edges[i].threshold - double(flips[i].high));
    }
    return seen;
}

}  // namespace

Displacement displacement(const Renderer& renderer, const Sample& sample, Axis axis) {
    const bool along_x = axis == Axis::x;
    const auto all = along_x ? probe_edges(sample.x, sample.y) : probe_edges(sample.y, sample.x);
    std::vector<Probe> probes;
    for (const ProbeEdge& probe_edge : all) probes.push_back(probe_of(probe_edge, axis));
    const int along = cell_height * cells_along, across = cell_length * cells_across;
    const auto flips =
        bisect(renderer, along_x ? raster_view(along, across) : raster_view(across, along), probes);

    Displacement found{.grid = {}, .finest_px = 1, .at_least_px = shifts_seen(flips, all)};
    while (found.finest_px / 4 > widest(flips)) found.finest_px /= 2;
    if (const double step = coarsest_step(flips, found.finest_px); step > 0)
        found.grid =
            SnapGrid{refined(step, flips), snap_rounding(flips, all, step), tie_rounding(flips, step)};
    return found;
}

}  // namespace zproof::measure
