/// Summed-area tables of stored codes, in 32 bits: the fastest kind, and the smallest. Sums are modulo 2^32,
/// so the table may wrap round; a box is exact wherever its own sum is below 2^32, which for 8-bit codes is
/// so up to 4096 x 4096 texels of 255, for 16-bit codes up to 256 x 256 of 65535.
#pragma once

#include <cstdint>
#include <span>

#include "texture/coverage.h"

namespace zproof::texture {

/// Row 0 first, channels side by side. values.size() == width * height * channels.
template <class Code>
struct Codes {
    int width = 0, height = 0, channels = 1;  ///< at least 1
    std::span<const Code> values{};
};

/// Sums over texels [0, i] x [0, j] at every (i, j), laid out as the codes are; sums.size() == values.size().
/// Sums do not depend on the number of threads: whole numbers have no order.
void sum_codes(const Codes<std::uint8_t>& codes, std::span<std::uint32_t> sums);
void sum_codes(const Codes<std::uint16_t>& codes, std::span<std::uint32_t> sums);

/// A table as sum_codes leaves it.
struct CodeSums {
    int width = 0, channels = 1;
    std::span<const std::uint32_t> sums{};

    /// The sum of a channel over a box of texels; the runs' weights are not applied.
    std::uint32_t box(const Run& columns, const Run& rows, int channel) const;
};

}  // namespace zproof::texture
