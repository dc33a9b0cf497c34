/// The colours of quantities that have an order.
#pragma once

#include <cstddef>

#include "frame/picture.h"

namespace zproof {

/// 0 to 1 as a byte, rounded to nearest; not by std::lround, which costs more than the rest of a picture.
inline std::uint8_t channel(double value) {
    const double raised = value < 0 ? 0 : value;
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): never negative
    return std::uint8_t(255 * (raised > 1 ? 1 : raised) + 0.5);
}

inline constexpr std::size_t viridis_pieces = 8;

/// The straight piece between viridis' nine stops that its colour at t lies in; t in [0, 1], 1 bright.
std::size_t viridis_piece(double t);

/// Viridis (van der Walt and Smith, 2015). Within one piece every channel only rises or only falls with t.
Rgb8 viridis(double t);

}  // namespace zproof
