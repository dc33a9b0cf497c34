/// A threshold mask of blue noise by the void-and-cluster method (Ulichney 1993).
#pragma once

#include <array>
#include <cstdint>

namespace zproof::texture {

constexpr int blue_noise_side = 64;

/// The rank of each cell of the mask, row by row: each of 0 to 4095 once. The first n ranks are spread over
/// the mask with as few low frequencies as that many points can have, for every n. The mask is a torus.
using BlueNoiseRanks = std::array<std::uint16_t, blue_noise_side * blue_noise_side>;

/// All in whole numbers. A point weighs w(d^2) on a cell at the distance d, the shortest way round: w(0) =
/// 2^32, w(n + 1) = floor(w(n) 3439140958 / 2^32), which is exp(-d^2 / 2 / 1.5^2). A cell's sum is that of
/// all points. The tightest cluster is the point of the greatest sum, the largest void the empty cell of the
/// least; of equals the first. One cell in eight begins as a point, by a hash. The tightest point moves to
/// the largest void until none has a lesser sum; these points have the first ranks, in the order in which the
/// tightest is taken away, last to first. The others are the largest voids, one after the other.
const BlueNoiseRanks& blue_noise_ranks();

}  // namespace zproof::texture
