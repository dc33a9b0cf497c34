/// Triangles' half-planes and nearness over the image, eight side by side: what a TriangleFilter says, but
/// for boxes, and made for one tile without being kept.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/search/filter_terms.h"
#include "compare/strips/kernel.h"
#include "scenes/scene.h"

namespace zproof {

/// Of one that is not trusted, errors are unlimited.
struct FiltersOfEight {
    strips::Eight points;  ///< of squares without extent: an edge's reach is its error
    struct {
        double a[8], b[8], c[8], error[8];
    } nearness;
};

class FiltersByEights {
  public:
    FiltersByEights(const Scene& scene, const View& view);

    /// Writes those of all triangles, in order; what follows the last one misses every place.
    void make(std::span<const std::uint32_t> triangles, std::vector<FiltersOfEight>& eights) const;

    struct Lens {
        FilterLens<Four> filters;
        Gauge<Four> gauge;
    };

  private:
    const Scene& scene_;
    alignas(four_alignment) Lens lens_;
};

}  // namespace zproof
