#include "filters/area/unit_squares.h"

#include "filters/area/texture_integral.h"

namespace zproof::oracle::area {

namespace {

constexpr double most_texels = 0x1p17;

}  // namespace

UnitSquares::UnitSquares(const Surfaces& surfaces, const View& view, Reconstruction reconstruction)
    : surfaces_(surfaces),
      weight_(weight_of(reconstruction)),
      size_{view.width + across() - 1, view.height + across() - 1},
      spans_(surfaces, {size_, 1 - weight_.half_side, 0.5}) {}

Homography<double> UnitSquares::texels_around(std::uint32_t triangle, int column, int row) const {
    const Point<double> p = middle(column, row);
    return from(*surfaces_.seen(triangle), p.x, p.y).texels;
}

std::optional<Visible> UnitSquares::visible(std::span<const std::uint32_t> candidates, int column,
                                            int row) const {
    std::optional<Visible> visible = visible_pieces(surfaces_, candidates, middle(column, row), 0.5);
    if (!visible) return std::nullopt;
    double cost = 0;
    for (const Piece& piece : visible->pieces) {
        cost += weight_.cost * texel_cost(piece.polygon, texels_around(piece.triangle, column, row));
        if (!(cost <= most_texels)) return std::nullopt;
    }
    return visible;
}

}  // namespace zproof::oracle::area
