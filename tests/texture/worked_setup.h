/// The worked set-up: a plane of 32-texel checks that runs to the horizon, its exact area means, and figures
/// of what methods make of it.
#pragma once

#include "texture/method.h"

namespace zproof::texture {

/// 256 x 256 pixels, eye (0, 1, 0) looking along +z 20 degrees down, 60 degrees high; plane y = 0; texels =
/// R(phi) (X, Z) 128 + (3.37, 1.71).
Homography<double> plane_of_checks(double phi);

/// 512 x 512 texels of checks, 32 a side, black where both indices are even or both odd.
LinearImage checks();

/// Exact mean of the checks over the pixel's square, in screen space.
double mean_of_checks(const Homography<double>& texels_from_raster, int x, int y);

struct Figures {
    double psnr_db = 0;           ///< peak 1, against the exact means, rows 56 to 255
    double texels_per_pixel = 0;  ///< reads
};
Figures figures(const Method& method, const FilterOptions& options, double phi);

}  // namespace zproof::texture
