/// The first look at a strip: pixels whose ids and depths plainly agree are sorted into bins by estimates.
#pragma once

#include <vector>

#include "compare/depth_estimate.h"

namespace zproof {

/// One thread at a time.
class Presort {
  public:
    explicit Presort(Projection projection) : projection_(projection) {}

    /// Forgets the laws of a tile.
    void clear() { ++tile_; }
    /// Fills in bins and what is open of whole chunks of the strip, and marks them as sorted. The laws are those of
    /// the tile; certain are only ratios that exceed neither of the largest.
    void sort(const LawsOfBoth& laws, const KnownLargest& largest, Strip& strip);

  private:
    struct Known {
        std::uint64_t tile = 0;
        DepthEstimate estimate;
    };
    const DepthEstimate& estimate_by(const LawsOfBoth& laws, std::uint32_t law);
    bool sort_one_law(const LawsOfBoth& laws, const KnownLargest& largest, std::size_t first, Strip& strip);
    bool sort_some_laws(const LawsOfBoth& laws, const KnownLargest& largest, std::size_t first, Strip& strip);

    Projection projection_;
    std::uint64_t tile_ = 1;
    std::vector<Known> known_;  ///< by law; of this tile where its tile is the present one
};

}  // namespace zproof
