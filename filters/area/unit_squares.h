/// The unit squares that a view's pixels are made of, under a reconstruction's weight: pixel (x, y) of those
/// from (x, y) to (x + across - 1, y + across - 1).
#pragma once

#include "filters/area/area_integral.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/row_spans.h"
#include "filters/area/visible.h"

namespace zproof::oracle::area {

class UnitSquares {
  public:
    /// Surfaces must outlive it.
    UnitSquares(const Surfaces& surfaces, const View& view, Reconstruction reconstruction);

    int across() const { return weight_.across; }
    Resolution size() const { return size_; }
    std::span<const Span> row(int row) const { return spans_.row(row); }
    /// The map to texels from offsets of a square's middle.
    Homography<double> texels_around(std::uint32_t triangle, int column, int row) const;
    /// Nothing where to integrate the pieces would take longer than samples do (docs/area-integral.md,
    /// "Cost").
    std::optional<Visible> visible(std::span<const std::uint32_t> candidates, int column, int row) const;

  private:
    Point<double> middle(int column, int row) const {
        return {column + 1 - weight_.half_side, row + 1 - weight_.half_side};
    }

    const Surfaces& surfaces_;
    const PixelWeight& weight_;
    Resolution size_;
    RowSpans spans_;
};

}  // namespace zproof::oracle::area
