/// The first look at a strip: pixels whose ids and depths plainly agree are sorted into bins by estimates.
#pragma once

#include <limits>
#include <vector>

#include "compare/depth_bins.h"

namespace zproof {

/// One thread at a time.
class Presort {
  public:
    explicit Presort(Projection projection) : projection_(projection) {}

    /// Forgets the laws of a tile.
    void clear() { ++tile_; }
    /// The largest ratio of each renderer.
    struct Largest {
        double candidate = 0, reference = 0;
    };

    /// Fills in bins and what is open of whole chunks of the strip, and marks them as sorted; raises the
    /// largest. The laws are those of the tile.
    void sort(const LawsOfBoth& laws, Largest& largest, const Strip& strip, SortedStrip& sorted);

  private:
    struct Known {
        std::uint64_t tile = 0;
        DepthEstimate estimate{};
        /// Depths whose ratios the largest have met already; none at first.
        float candidate_counted = std::numeric_limits<float>::quiet_NaN(),
              reference_counted = std::numeric_limits<float>::quiet_NaN();
    };
    /// Pixels whose ratios may exceed the largest.
    struct Exceeding {
        const DepthLaw& law;
        const Strip::Side& shown;
        ColumnMask mask;
    };
    /// What a chunk is sorted by.
    struct Source {
        const LawsOfBoth& laws;
        Asked& asked;
        Largest& largest;
        const Strip& strip;
        std::size_t first;  ///< of the chunk's pixels in the strip
    };
    const DepthEstimate& estimate_by(const Source& source, std::uint32_t law);
    static DepthsOfBoth depths_of(const Source& source);
    EstimatedRow estimated_by_one(std::uint32_t law, const Source& source);
    void set_estimates_of_candidate(const Source& source, Estimates& each);
    Estimates estimates_of_reference(const Estimates& of_candidate, const Source& source);
    EstimatedRow estimated_by_each(ColumnMask pixels, const Source& source);
    void raise_largest(const EstimatedRow& row, ColumnMask pixels, const Source& source);
    void raise(const Exceeding& pixels, const Source& source, float& counted, double& largest) const;
    struct Agreement {
        ColumnMask same, agreed;  ///< both show the same; and are not bare
    };
    bool settle(const EstimatedRow& row, const Agreement& pixels, const Source& source, SortedStrip& sorted);
    bool sort_one_law(const Source& source, SortedStrip& sorted);
    bool sort_some_laws(const Source& source, SortedStrip& sorted);

    Projection projection_;
    std::uint64_t tile_ = 1;
    std::vector<Known> known_;  ///< by law; of this tile where its tile is the present one
};

}  // namespace zproof
