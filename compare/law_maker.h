/// Makes the laws of many triangles' depths, four triangles at a time.
#pragma once

#include <span>
#include <vector>

#include "compare/witness.h"

namespace zproof {

/// The laws of the same triangles, for either witness.
struct LawsOfBoth {
    std::vector<DepthLaw> candidate, reference;
};

class LawMaker {
  public:
    LawMaker(const Scene& scene, const Witness& candidate, const Witness& reference);

    /// Appends the laws of triangles of the scene, in their order: the bits of depth_law_of.
    void append(std::span<const PrimitiveId> triangles, LawsOfBoth& laws) const;

    /// What four triangles are asked about.
    struct Lens {
        Sight<Lanes> first_pixel;
        Gauge<Lanes> gauge;
        Resolution size;
        Lanes near_depth, far_depth;
        struct Side {
            CommonTerms terms;
            KeepsToCorners keeps;
        };
        Side candidate, reference;
    };

  private:
    const Scene& scene_;
    const Witness &candidate_, &reference_;
    Lens lens_;
    bool is_common_;  ///< have both witnesses terms that hold for every triangle?
};

}  // namespace zproof
