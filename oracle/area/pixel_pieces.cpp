#include "oracle/area/pixel_pieces.h"

#include "oracle/area/texture_integral.h"

namespace zproof::oracle::area {

namespace {

constexpr double most_texels = 0x1p17;
constexpr double gaussian_cost = 4;  ///< beside a mean without weights

}  // namespace

double reach_px(Reconstruction reconstruction) { return is_gaussian(reconstruction) ? 1 : 0.5; }

Homography<double> texels_around(const Surfaces& surfaces, std::uint32_t triangle,
                                 const Point<double>& centre) {
    return from(*surfaces.seen(triangle), centre.x, centre.y).texels;
}

std::optional<Visible> pixel_pieces(const Surfaces& surfaces, std::span<const std::uint32_t> candidates,
                                    const Point<double>& centre, Reconstruction reconstruction) {
    std::optional<Visible> visible = visible_pieces(surfaces, candidates, centre, reach_px(reconstruction));
    if (!visible) return std::nullopt;
    double cost = 0;
    for (const Piece& piece : visible->pieces) {
        cost += (is_gaussian(reconstruction) ? gaussian_cost : 1) *
                texel_cost(piece.polygon, texels_around(surfaces, piece.triangle, centre));
        if (!(cost <= most_texels)) return std::nullopt;
    }
    return visible;
}

}  // namespace zproof::oracle::area
