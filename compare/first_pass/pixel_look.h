/// One pixel before both witnesses.
#pragma once

#include "compare/memory.h"
#include "compare/witness.h"

namespace zproof {

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

}  // namespace zproof
