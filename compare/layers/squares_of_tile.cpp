#include "compare/layers/squares_of_tile.h"

#include <bit>

#include "compare/strips/dispatch.h"

namespace zproof {

namespace {

/// Where values that may be off by `unsure` are certainly above or below 0.
struct Signs {
    TileMask above, below;
};
Signs signs(const Affine<double>& f, const TilePlace& tile, double unsure) {
    strips::Signs rows;
    strips::widest_kernel().set_signs({f.a, f.b, f.c, unsure, tile.left, tile.top}, rows);
    return {TileMask::of(rows.above), TileMask::of(rows.below)};
}

double reach(const Affine<double>& f, double half_side_px) {
    return reach(f, Around{0, 0, half_side_px, half_side_px});
}

}  // namespace

PlaceMasks places_of_squares(const TriangleFilter& filter, std::uint32_t edges, const TilePlace& tile,
                             double half_side_px) {
    TileMask covers = TileMask::all(), misses;
    for (; edges != 0; edges &= edges - 1) {
        const auto k = std::size_t(std::countr_zero(edges));
        const Affine<double>& e = filter.edge[k];
        const Signs inside = signs(e, tile, reach(e, half_side_px) + filter.edge_error[k]);
        covers &= inside.above;
        misses |= inside.below;
    }
    return {covers & ~misses, ~covers & ~misses};
}

OrderMasks orders_in_squares(const TriangleFilter& front, const TriangleFilter& back, const TilePlace& tile,
                             double half_side_px) {
    const Affine<double> ahead = front.nearness - back.nearness;
    const Signs order =
        signs(ahead, tile, reach(ahead, half_side_px) + front.nearness_error + back.nearness_error);
    return {.ahead = order.above, .behind = order.below};
}

}  // namespace zproof
