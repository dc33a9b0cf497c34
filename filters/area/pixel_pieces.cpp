#include "filters/area/pixel_pieces.h"

#include "filters/area/pixel_weight.h"
#include "filters/area/texture_integral.h"

namespace zproof::oracle::area {

namespace {

constexpr double most_texels = 0x1p17;

}  // namespace

Homography<double> texels_around(const Surfaces& surfaces, std::uint32_t triangle,
                                 const Point<double>& centre) {
    return from(*surfaces.seen(triangle), centre.x, centre.y).texels;
}

std::optional<Visible> pixel_pieces(const Surfaces& surfaces, std::span<const std::uint32_t> candidates,
                                    const Point<double>& centre, Reconstruction reconstruction) {
    const PixelWeight& weight = weight_of(reconstruction);
    std::optional<Visible> visible = visible_pieces(surfaces, candidates, centre, weight.half_side);
    if (!visible) return std::nullopt;
    double cost = 0;
    for (const Piece& piece : visible->pieces) {
        cost += weight.cost * texel_cost(piece.polygon, texels_around(surfaces, piece.triangle, centre));
        if (!(cost <= most_texels)) return std::nullopt;
    }
    return visible;
}

}  // namespace zproof::oracle::area
