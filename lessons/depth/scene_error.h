/// The depths of a scene's own pixels, by every interpolation and format, against the exact ones.
#pragma once

#include <string>
#include <vector>

#include "frame/plane.h"
#include "lessons/depth/bound.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::study::depth {

/// What a pixel's own triangle is, and the exact depth there.
struct SeenPixel {
    Pixel at;
    double depth = 0;  ///< camera depth of the plane at the pixel's centre, to a share of 2^-40
};

/// A triangle before near, and the pixels that show it, in raster order.
struct SeenTriangle {
    Drawn drawn;
    double weight_error = 0;  ///< of drawn (bound.h)
    std::vector<SeenPixel> pixels;
};

/// What a view shows between the planes. Visibility is the rasterizer's, depths are the scene's: worked out
/// in interval arithmetic, and in rationals where that leaves more than 2^-40 of doubt.
struct Seen {
    Resolution size;
    std::vector<SeenTriangle> triangles;  ///< by index in the scene; a triangle cut by near may come twice
    std::size_t pixels = 0;
    std::size_t left_out = 0;  ///< pixels that show a triangle nearer than near or beyond far
    double nearest = 0, farthest = 0, median = 0;  ///< of the depths; 0 where there is no pixel
};

/// Throws std::invalid_argument for a parallel projection, whose depth is affine in the image.
Seen seen_in(const Scene& scene, const View& view, const Planes& planes);

/// How the errors of one interpolation and format are spread: |stored - exact| / exact.
struct ErrorSpread {
    Format format;
    Interpolation interpolation = Interpolation::reciprocal;
    std::size_t pixels = 0;
    double median = 0, p99 = 0, largest = 0;  ///< share of the depth
    double largest_absolute = 0;              ///< scene units
    double largest_of_bound = 0;              ///< error / depth_bound(); at most 1
    std::vector<std::size_t> histogram;       ///< pixels per decade_bins
    Plane<float> map;                         ///< share of the depth; NaN where nothing is seen
};

/// Upper ends of the histogram's bins, shares of the depth: 1e-9, 10^-8.5 ... 1, inf.
std::vector<double> histogram_ends();

ErrorSpread error_spread(const Seen& seen, const Format& format, Interpolation interpolation,
                         const Planes& planes);

/// The share of all pixels at which a second layer, the same triangle with every corner `delta` (scene units)
/// deeper along its view ray, is not farther in the buffer. Corners are coded alike, 1/d is interpolated.
double fighting_share(const Seen& seen, const Format& format, const Planes& planes, double delta);

}  // namespace zproof::study::depth
