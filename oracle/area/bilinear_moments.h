/// Integrals of 1, s, t and s t over a convex piece of the image, where (s, t) is the place within one cell
/// of the texture: all that a bilinear surface needs.
#pragma once

#include "math/homography.h"
#include "oracle/area/polygon.h"
#include "oracle/area/texel_walk.h"

namespace zproof::oracle::area {

/// px^2.
struct BilinearMoments {
    double one = 0, s = 0, t = 0, st = 0;
};

/// Texel coordinates as quotients: s = S / W in [0, 1], t = T / W likewise. By a rule of degree 5 on pieces
/// of nearly constant W: each moment's error is at most 3e-9 of the area (docs/area-integral.md,
/// "Bilinear").
BilinearMoments bilinear_moments(const Polygon<double>& piece, const Homography<double>& cell);

/// exp(-2 r^2) - exp(-2), r in px from the origin of the offsets.
double gaussian_weight(const Point<double>& p);

/// The moments weighted by gaussian_weight(), which must not be negative on the piece. For pieces that fit
/// into a square of 1/4 px each moment's error is at most 1.5e-5 of the area (docs/area-integral.md,
/// "Gaussian").
BilinearMoments gaussian_moments(const Polygon<double>& piece, const Homography<double>& cell);

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
