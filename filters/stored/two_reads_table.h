/// The place and the blend of two bilinear reads, one of a level and one of the next coarser one, that best
/// make the mean over a square (after Manson and Schaefer 2014, Bilinear Accelerated Filter Approximation).
/// docs/texture-filters.md, "Table of reads", defines ours. All is decided in whole numbers.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace zproof::texture {

/// Where the reads stand beside the lookup's place, and what each weighs.
struct TwoReads {
    glm::ivec2 finer{0}, coarser{0};  ///< eighths of a texel of the read's own level
    int share = 0;                    ///< of the finer read, 64ths, 0 to 64

    friend bool operator==(const TwoReads&, const TwoReads&) = default;
};

class TwoReadsTable {
  public:
    /// Sides of the square, eighths of a texel of the finer level.
    static constexpr int least_side = 8, most_side = 32;
    /// Cells along a texel of the coarser level, of either axis.
    static constexpr int cells = 8;

    TwoReadsTable();

    /// The reads for a side from `least_side` to `most_side` and the cell that holds the place, from 0 to
    /// `cells` exclusive.
    TwoReads at(int side, const glm::ivec2& cell) const;

  private:
    std::vector<TwoReads> entries_;  ///< of the first half of the cells along either axis
};

}  // namespace zproof::texture
