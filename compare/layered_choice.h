/// Which tiles are worth having all their pixels looked at together. It is a matter of time only: no verdict
/// depends on it.
#pragma once

#include "compare/open_tiles.h"
#include "compare/triangle_filter.h"
#include "compare/witness.h"

namespace zproof {

/// The centres of a tile's open pixels, of which there are some.
Around centres_of(const OpenTiles& open, int column, int row);

/// Boxes that hold every open pixel of such a tile with `reach_px` around it; none for other tiles, nor for
/// any where there are too few pixels for a look at every triangle of the scene.
AskedBoxes boxes_worth_layers(const Comparands& of, const OpenTiles& open, double reach_px);

/// Is such a tile still worth it, once it is known how many triangles come near its open pixels?
bool is_worth_layers(std::size_t pixels, std::size_t triangles);

}  // namespace zproof
