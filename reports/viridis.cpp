#include "reports/viridis.h"

#include <algorithm>
#include <array>

namespace zproof {

namespace {

constexpr std::array<std::array<double, 3>, viridis_pieces + 1> stops{{{68, 1, 84},
                                                                       {71, 45, 123},
                                                                       {59, 82, 139},
                                                                       {44, 114, 142},
                                                                       {33, 145, 140},
                                                                       {40, 174, 128},
                                                                       {94, 201, 98},
                                                                       {173, 220, 48},
                                                                       {253, 231, 37}}};

double place_of(double t) { return std::clamp(t, 0.0, 1.0) * viridis_pieces; }

/// std::lerp for positive ends and t in [0, 1], without its other cases.
double between(double from, double to, double t) {
    const double there = from + t * (to - from);
    return from < to ? std::min(there, to) : std::max(there, to);
}

}  // namespace

std::size_t viridis_piece(double t) { return std::min(std::size_t(place_of(t)), viridis_pieces - 1); }

Rgb8 viridis(double t) {
    const std::size_t low = viridis_piece(t);
    const auto mix = [&](std::size_t c) {
        return channel(between(stops[low][c], stops[low + 1][c], place_of(t) - double(low)) / 255);
    };
    return {mix(0), mix(1), mix(2)};
}

}  // namespace zproof
