/// Which tiles are worth having all their pixels looked at together. It is a matter of time only: no verdict
/// depends on it.
#pragma once

#include "compare/first_pass/open_tiles.h"
#include "compare/search/asked_tiles.h"
#include "compare/witness.h"

namespace zproof {

struct LayeredChoice {
    AskedTiles asked;      ///< such tiles, each with one box: its open pixels and what is around them
    Bulk<Around> centres;  ///< by tile, where asked: the centres of its open pixels
};

/// No tile is asked about where there are too few pixels for a look at every triangle of the scene.
LayeredChoice choose_layered_tiles(const Comparands& of, const OpenTiles& open, double reach_px);

/// Is such a tile still worth it, once it is known how many triangles come near its open pixels?
bool is_worth_layers(const OpenTiles::Tile& open, std::size_t triangles);

}  // namespace zproof
