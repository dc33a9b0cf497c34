/// Integrals of 1, s, t and s t over a convex piece of the image, where (s, t) is the place within one cell
/// of the texture: all that a bilinear surface needs. Each for every pixel that the piece counts for.
#pragma once

#include <array>

#include "filters/area/pixel_weight.h"
#include "filters/area/polygon.h"
#include "filters/area/texel_walk.h"
#include "math/affine.h"

namespace zproof::oracle::area {

/// A number for each pixel that a unit square counts for, row by row.
template <int across>
using EachPixel = std::array<double, std::size_t(across* across)>;

/// px^2.
template <int across>
struct BilinearMoments {
    EachPixel<across> one{}, s{}, t{}, st{};
};

/// Texel coordinates as quotients: s = S / W in [0, 1], t = T / W likewise. The piece lies in one of the
/// weight's blocks, in offsets from the unit square's middle. Under a weight of 1, each moment's error is at
/// most 3e-9 of the area (docs/area-integral.md, "Bilinear"), else that of the weight ("Weights").
template <int across>
BilinearMoments<across> bilinear_moments(const Polygon<double>& piece, const Homography<double>& cell,
                                         const PixelWeight& weight);

/// The moments over whole cells: under a weight of 1 as a series in the slopes p, q of Z per cell, whose left
/// out terms are smaller than 1e-12, else by Gauss's rule of two or three points along s and along t.
template <int across>
class WholeCellMoments {
  public:
    /// All must outlive it; these columns of a row are asked for.
    WholeCellMoments(const Homography<double>& map, const TexelLattice<double>& lattice,
                     const PixelWeight& weight, std::int64_t row, std::int64_t first, std::int64_t last);

    /// Are the cells small enough?
    bool hold() const { return hold_; }
    BilinearMoments<across> of(const Cell& cell) const;

  private:
    double step_px(std::int64_t row, std::int64_t first, std::int64_t last, double least_z) const;

    const Homography<double>& map_;
    const TexelLattice<double>& lattice_;
    const PixelWeight& weight_;
    bool hold_ = false;
    std::span<const GaussNode> rule_{};
};

}  // namespace zproof::oracle::area
