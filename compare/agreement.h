/// The first pass: pixels at which the two frames plainly agree are settled at once, the rest is left open.
#pragma once

#include <atomic>

#include "compare/error_map.h"
#include "compare/memory.h"
#include "compare/open_tiles.h"
#include "compare/witness.h"

namespace zproof {

/// What both depths were held against; sums of integers and maxima, so the order of adding does not matter.
struct Tally {
    BoundRecord candidate, reference;
};

void count(BoundRecord& record, double error_over_bound);
void add(Tally& sum, const Tally& part);

/// A pixel that the first pass leaves open, with what it knows already.
struct OpenPixel {
    Finding finding;  ///< verdict: agree until settled
    bool candidate_invalid = false, reference_invalid = false;
    bool candidate_depth_lawful = true, reference_depth_lawful = true;
    double reference_error_over_bound = 0;
};

/// Do both say the same, lawfully?
bool is_settled(const OpenPixel& pixel);

/// Looks into pixels one by one, settled or not.
class PixelLook {
  public:
    PixelLook(const Scene& scene, const Witness& candidate, const Witness& reference);

    /// `known_reference_ratio` is the error over the bound of the reference's lawful depth, or `unsettled`.
    OpenPixel at(int x, int y, double known_reference_ratio = unsettled);

  private:
    /// What both witnesses may say of one triangle's depth.
    struct DepthOfBoth {
        TriangleDepth candidate, reference;
    };
    const DepthOfBoth& depth_of_both(PrimitiveId primitive);

    std::size_t triangle_count_;
    const Witness &candidate_, &reference_;
    Memory<std::uint32_t, DepthOfBoth> triangles_;
};

/// The largest ratios that any part of the image has shown so far. Only what work is saved depends on it.
struct LargestSoFar {
    std::atomic<double> candidate = 0, reference = 0;
};

/// Rows [top, bottom) of a view; top is the first of a row of tiles.
struct Rows {
    int top, bottom;
    LargestSoFar& largest;
    ErrorMaps* errors = nullptr;  ///< where there are some, what these rows of them hold is written
};

/// Opens the pixels that are not settled. What the depths were held against where both name the same triangle.
Tally compare_rows(const Scene& scene, const Witness& candidate, const Witness& reference, const Rows& rows,
                   OpenTiles& open);

}  // namespace zproof
