/// Makes the laws of many triangles' depths, or what becomes of them in a tile, four triangles at a time.
#pragma once

#include <span>

#include "compare/bounds/depth_tolerance.h"
#include "compare/witness.h"

namespace zproof {

/// A place for each of some triangles.
struct TileTolerances {
    std::span<DepthTolerance> far_off;
    std::span<CornerTolerance> next_to_corners;
};

class LawMaker {
  public:
    LawMaker(const Scene& scene, const Witness& candidate, const Witness& reference);

    /// Writes the laws of triangles of the scene from a place on, in their order: the bits of depth_law_of.
    /// Makes room where there is none; laws at later places are lost.
    void make(std::span<const PrimitiveId> triangles, std::size_t first_place, LawsOfBoth& laws) const;
    /// Writes the tolerances of triangles of the scene in a tile, in their order: the bits of tolerances_of
    /// their laws, which are not kept.
    void make_tolerances(std::span<const PrimitiveId> triangles, const PixelBox& tile,
                         const TileTolerances& tolerances) const;

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
    template <class Make>
    void for_each_four(std::span<const PrimitiveId> triangles, const Make& make) const;
    template <class Make>
    void for_each(std::span<const PrimitiveId> triangles, const Make& make) const;

    Lens lens_;
    const Scene& scene_;
    const Witness &candidate_, &reference_;
    bool is_common_;  ///< have both witnesses terms that hold for every triangle?
};

}  // namespace zproof
