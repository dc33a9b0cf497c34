/// Which triangles come near which pixels.
#pragma once

#include "compare/neighbourhood.h"
#include "compare/tile_search.h"
#include "compare/triangle_filter.h"

namespace zproof {

/// What the search knows of every view: asked for single pixels.
class PixelSearch {
  public:
    explicit PixelSearch(const View& view) : boxes_(view), filters_(view) {}

    /// Can the triangle be ruled out within reach_px of the pixel's centre, in x and in y?
    bool misses(const CornersWorld& p_world, const Site& site) const;
    const TriangleFilters& filters() const { return filters_; }

  private:
    BoxProjection boxes_;
    TriangleFilters filters_;
};

/// Fills site.triangles, for every site, with all triangles whose image (in front of half the near depth) may
/// come within site.reach_px of the pixel's centre in x and in y. Too many is harmless, too few is not: image
/// bounds are widened by the rounding error of their own computation. Sites may stand in any order. Runs on
/// all threads; one pass over the scene.
void find_nearby_triangles(const Scene& scene, const View& view, std::span<Site> sites);

}  // namespace zproof
