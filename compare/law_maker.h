/// Makes the laws of many triangles' depths, four triangles at a time.
#pragma once

#include <span>

#include "compare/witness.h"

namespace zproof {

class LawMaker {
  public:
    LawMaker(const Scene& scene, const Witness& candidate, const Witness& reference);

    /// Writes the laws of triangles of the scene from a place on, in their order: the bits of depth_law_of.
    /// Makes room where there is none; laws at later places are lost.
    void make(std::span<const PrimitiveId> triangles, std::size_t first_place, LawsOfBoth& laws) const;

    /// What four triangles are asked about.
    struct alignas(four_alignment) Lens {
        Sight<Four> first_pixel;
        Gauge<Four> gauge;
        Four near_depth, far_depth;
        struct Side {
            CommonTerms terms;
            KeepsToCorners keeps;
        };
        Side candidate, reference;
        Resolution size;
    };

  private:
    void make_one_by_one(std::span<const PrimitiveId> triangles, std::size_t first_place,
                         LawsOfBoth& laws) const;

    Lens lens_;
    const Scene& scene_;
    const Witness &candidate_, &reference_;
    bool is_common_;  ///< have both witnesses terms that hold for every triangle?
};

}  // namespace zproof
