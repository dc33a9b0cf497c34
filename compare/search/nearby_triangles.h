/// Which triangles come near which pixels.
#pragma once

#include <span>

#include "compare/truth/neighbourhood.h"

namespace zproof {

/// Fills site.triangles, for every site, with all triangles whose image (in front of half the near depth) may
/// come within site.reach_px of the pixel's centre in x and in y. Too many is harmless, too few is not: image
/// bounds are widened by the rounding error of their own computation. Sites may stand in any order. Runs on
/// all threads; one pass over the scene.
void find_nearby_triangles(const Scene& scene, const View& view, std::span<Site> sites);

}  // namespace zproof
