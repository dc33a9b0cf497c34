/// Integrals of 1, s, t and s t over a convex piece of the image, where (s, t) is the place within one cell
/// of the texture: all that a bilinear surface needs.
#pragma once

#include "filters/area/pixel_weight.h"
#include "filters/area/polygon.h"
#include "filters/area/texel_walk.h"
#include "math/affine.h"

namespace zproof::oracle::area {

/// px^2.
struct BilinearMoments {
    double one = 0, s = 0, t = 0, st = 0;
};

/// Texel coordinates as quotients: s = S / W in [0, 1], t = T / W likewise. By a rule of degree 5 on pieces
/// of nearly constant W: each moment's error is at most 3e-9 of the area (docs/area-integral.md,
/// "Bilinear").
BilinearMoments bilinear_moments(const Polygon<double>& piece, const Homography<double>& cell);

/// The moments under a weight, by its rule: for a piece of one of its blocks, in offsets from the pixel's
/// centre (docs/area-integral.md, "Weights").
BilinearMoments weighted_moments(const Polygon<double>& piece, const Homography<double>& cell,
                                 const PixelWeight& weight);

/// The moments over whole cells, as a series in the slopes p, q of Z per cell: terms left out are smaller
/// than 1e-12.
class WholeCellMoments {
  public:
    explicit WholeCellMoments(const TexelLattice<double>& lattice) : lattice_(lattice) {}

    /// Is the series good for these columns of a row?
    bool holds_for(std::int64_t row, std::int64_t first, std::int64_t last) const;
    BilinearMoments of(const Cell& cell) const;

  private:
    const TexelLattice<double>& lattice_;
};

}  // namespace zproof::oracle::area
