/// Squares around all pixels of a tile, side by side: what TriangleFilter says of one.
#pragma once

#include "compare/search/triangle_filter.h"
#include "compare/tile_mask.h"

namespace zproof {

struct PlaceMasks {
    TileMask covers, cuts;  ///< cuts: neither covers nor misses for certain
};

/// TriangleFilter::place_of the squares of that half-side, as far as some of the edges say: bit k is edge k,
/// and every square lies inside the others. For filters that are trusted.
PlaceMasks places_of_squares(const TriangleFilter& filter, std::uint32_t edges, const TilePlace& tile,
                             double half_side_px);

struct OrderMasks {
    TileMask ahead, behind;  ///< of `front`, all over the square, for certain
};

/// order_in() the squares of that half-side.
OrderMasks orders_in_squares(const TriangleFilter& front, const TriangleFilter& back, const TilePlace& tile,
                             double half_side_px);

}  // namespace zproof
