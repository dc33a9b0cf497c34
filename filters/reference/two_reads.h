/// The table of reads of docs/texture-filters.md, a second time: densities laid out along a line, and each
/// share tried.
#pragma once

#include <array>
#include <mutex>
#include <vector>

namespace zproof::oracle::filter_reference {

/// What a lookup reads of a level and of the next coarser one.
struct TwoReadsFound {
    std::array<int, 2> finer, coarser;  ///< beside the place along u and v, eighths of a texel of the level
    int finer_64ths;                    ///< the finer read's weight; the coarser one's is the rest of 64
};

class TwoReadsSearch {
  public:
    static constexpr int most_side = 32, cells = 8;

    /// The reads for a side in eighths of a texel of the finer level, 8 to most_side, and the eighth of a
    /// texel of the coarser level that holds the place. Found when first asked for; from many threads.
    const TwoReadsFound& at(int side, int column, int row);

  private:
    static constexpr std::size_t entries = std::size_t{most_side + 1} * cells * cells;
    std::vector<TwoReadsFound> found_{entries};
    std::vector<std::once_flag> once_{entries};
};

/// The one search of all of the program's references.
TwoReadsSearch& two_reads_search();

}  // namespace zproof::oracle::filter_reference
