/// Bilinear reads of many lookups, side by side: what is the same for every method that has a mip chain, by
/// the widest vectors that the machine has.
///
/// kernel_scalar.cpp, kernel_avx2.cpp and kernel_avx512.cpp are compiled for one instruction set each and
/// share the algorithm of taps.inl, block.inl and lines.inl. All give the bits of reading tap by tap
/// (read_bilinear() of filters/methods/tap_rule.h): every product, sum and comparison is the same, in the
/// same order within a lookup. Plain structs only: an inline function in here would be merged by the linker
/// into whichever instruction set's copy it meets first.
#pragma once

#include <cstdint>

#include "texture/texels.h"

namespace zproof::texture::reads {

/// An image of the chain, cut into tiles of 16 x 16 texels (tiles.h). Numbers that kernels pick by index:
/// doubles all of them, whole where they count something.
struct Level {
    double first = 0;                      ///< floats of the chain before this image's first tile
    double row_of_tiles = 0;               ///< floats
    double width = 0, height = 0;          ///< texels
    double per_width = 0, per_height = 0;  ///< 1 / width, 1 / height, rounded
    double scale_x = 1, scale_y = 1;       ///< texels per texel of level 0
};

/// The places of the levels, and what lies beyond their edges.
struct Chain {
    const float* texels = nullptr;  ///< RGBA; the first texel is 0 and belongs to no level
    const Level* levels = nullptr;
    Wrap u = Wrap::repeat, v = Wrap::repeat;
};

/// Reads that wait to be summed, and whose they are.
struct Block {
    static constexpr int most = 64;        ///< reads, and lookups; a multiple of every kernel's lanes
    alignas(64) double x[most], y[most];   ///< places, in texels of the read's own level; any value
    alignas(64) double weight[most];       ///< of the whole read
    alignas(64) std::int32_t level[most];  ///< index of a Level
    double* sum[most];    ///< RGBA of each lookup, to which its reads are added in order; no two the same
    int begin[most + 1];  ///< each lookup's first read, and the read after the last one's last
    int count = 0;        ///< reads
    int lookups = 0;
    // What a kernel finds: the four taps of each read, upper left, upper right, lower left, lower right.
    alignas(64) std::int64_t offset[4][most];  ///< in floats, from the chain's first texel
    alignas(64) double tap_weight[4][most];
};

/// The places of equal taps on a line: the i-th of n, from 0, at (i + first) / (n + more) - 1/2 of its
/// length.
struct TapSpacing {
    double first = 0.5, more = 0;
};

/// Lookups that are each the mean of trilinear taps on a line, linear about its middle.
struct Lines {
    static constexpr int most = 128;         ///< lookups; a multiple of every kernel's lanes
    TapSpacing spacing;                      ///< of all
    alignas(64) double x[most], y[most];     ///< the middle, in texels of level 0; any value
    alignas(64) double across[most];         ///< from one end to the other, in texels of level 0; any value
    alignas(64) double down[most];           ///< the same in y
    alignas(64) double taps[most];           ///< whole, at least 1
    alignas(64) double share[most];          ///< of the coarser level, [0, 1); where 0, it is not read
    alignas(64) std::int32_t finer[most];    ///< index of a Level
    alignas(64) std::int32_t coarser[most];  ///< the same; that of any level where the share is 0
    double* sum[most];                       ///< RGBA of each lookup, to which its taps are added in order
    int count = 0;
};

struct Kernel {
    const char* name = "";
    /// The taps of a block's reads. What of its arrays lies behind `count` is overwritten.
    void (*find_taps)(const Chain& chain, Block& block) noexcept = nullptr;
    /// Adds those taps to the sums of their lookups.
    void (*add_up)(const Chain& chain, const Block& block) noexcept = nullptr;
    /// Adds the taps of lines to their sums. What of the arrays lies behind `count` is overwritten.
    void (*add_lines)(const Chain& chain, Lines& lines) noexcept = nullptr;
};

namespace scalar {
extern const Kernel kernel;
}
namespace avx2 {
extern const Kernel kernel;
}
namespace avx512 {
extern const Kernel kernel;
}

/// One for each InstructionSet of the machine, for widest_of() and available_of().
inline constexpr const Kernel* kernels[] = {
    &scalar::kernel,
#ifdef __x86_64__
    &avx2::kernel,
    &avx512::kernel,
#endif
};

}  // namespace zproof::texture::reads
