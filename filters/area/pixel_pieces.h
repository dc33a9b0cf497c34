/// What a pixel's mean is made of: the visible pieces within a reconstruction's reach, where they are few.
#pragma once

#include "filters/area/area_integral.h"
#include "filters/area/visible.h"

namespace zproof::oracle::area {

/// The map to texels from offsets of a pixel's centre.
Homography<double> texels_around(const Surfaces& surfaces, std::uint32_t triangle,
                                 const Point<double>& centre);

/// Nothing where to integrate them would take longer than samples do (docs/area-integral.md, "Cost").
std::optional<Visible> pixel_pieces(const Surfaces& surfaces, std::span<const std::uint32_t> candidates,
                                    const Point<double>& centre, Reconstruction reconstruction);

}  // namespace zproof::oracle::area
