/// Small scenes written in raster coordinates, and pictures of what was drawn.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <random>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "rasterizer/rules.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

using Triangle = std::array<glm::vec3, 3>;

/// Corners in raster coordinates (y down), all at camera depth 1.
Triangle at_pixels(float x0, float y0, float x1, float y1, float x2, float y2);

/// No two triangles share a vertex index.
Scene scene_of(const std::vector<Triangle>& triangles);

/// A parallel view in which the world point (x, -y, -d) is seen at raster (x, y) and camera depth d, exactly
/// for images whose sides are powers of two. Depths 0.5 to 100.
View raster_view(int width, int height);

/// One digit per pixel: how many of the triangles, each drawn alone, cover it; '.' for none. Begins with a
/// newline, as raw strings do.
std::string picture(const std::vector<Triangle>& triangles, int width, int height,
                    const Rules& rules = correct_rules);
std::string all_ones(int width, int height);

/// The id of each pixel, one digit, '.' for background.
std::string ids(const Frame& frame);

double uniform(std::mt19937& random, double low, double high);

/// `count` triangles around a box's middle, corners uniform in the box.
std::vector<Triangle> random_triangles(std::mt19937& random, int count, glm::dvec3 low, glm::dvec3 high);

/// Bit-for-bit equality of both AOVs.
bool same_bits(const Frame& a, const Frame& b);

}  // namespace zproof::rasterizer
