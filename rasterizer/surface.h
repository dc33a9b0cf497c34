/// What a pixel's centre sees of a triangle: where on it, and the attributes there.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// The view ray through a raster position, relative to the eye, world axes: from + t to.
struct PixelRay {
    glm::dvec3 from{0}, to{0};
};

PixelRay pixel_ray(const View& view, double x_raster, double y_raster);

/// Every view ray of a view: both parts at raster (0, 0), and what a pixel's step adds to them.
struct PixelRays {
    PixelRay origin, per_x, per_y;
};

PixelRays pixel_rays(const View& view);

/// Perspective-correct barycentrics of the point where the line meets the triangle's plane; they add up to 1.
/// A third each where the triangle is seen edge-on, or double cannot tell.
using Barycentrics = std::array<double, 3>;
Barycentrics barycentrics(const PixelRay& line, const std::array<glm::dvec3, 3>& corners_from_eye);

/// The mean of the corners' values, weighted by barycentrics.
template <class Value>
Value blended(const Barycentrics& b, const std::array<Value, 3>& at_corners) {
    return b[0] * at_corners[0] + b[1] * at_corners[1] + b[2] * at_corners[2];
}

}  // namespace zproof::rasterizer
