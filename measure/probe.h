/// The apparatus: views in which every position is exact, and bisection over float32 coordinates.
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <stdexcept>
#include <vector>

#include "measure/measurement.h"
#include "measure/renderer.h"

namespace zproof::measure {

/// A picture does not show what every renderer must show, whatever its precision.
struct Unmeasurable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A parallel view in which the world point (x, -y, -1) is seen at raster (x, y), exactly where the sides are
/// powers of two: window and image have the same size.
View raster_view(int width, int height);

/// A raster position on the axis that is measured, and on the other one.
struct RasterPoint {
    double along = 0, across = 0;
};
using RasterTriangle = std::array<RasterPoint, 3>;

/// Corners are rounded to float32; all at depth 1.
void add_triangle(Scene& scene, Axis axis, const RasterTriangle& corners);

/// Is any triangle seen there? (along, across) is the pixel.
bool is_covered(const Frame& frame, Axis axis, int along, int across);

/// A question to a renderer whose answer turns from yes to no where a float32 coordinate passes some place
/// between low and high.
struct Probe {
    float low = 0, high = 0;
    std::function<void(Scene&, float)> draw;   ///< adds the probe's triangles
    std::function<bool(const Frame&)> answer;  ///< looks at the probe's own pixels only
};

/// Two neighbouring float32: yes at low, no at high.
struct Flip {
    float low = 0, high = 0;
};

/// Finds where each answer turns. All probes are drawn into one scene, so it takes at most 34 pictures.
/// Throws Unmeasurable where an answer is not yes at low and no at high.
std::vector<Flip> bisect(const Renderer& renderer, const View& view, const std::vector<Probe>& probes);

/// Finds where one answer turns. The lanes, at least two, ask it in parts of one picture that do not touch,
/// each at a place of its own: 64 of them take at most 6 pictures. Throws as `bisect` does.
Flip bisect_in_lanes(const Renderer& renderer, const View& view, const std::vector<Probe>& lanes);

/// The number with the fewest binary places in a bracket of width > 0.
double simplest_in(const Bracket& bracket);

}  // namespace zproof::measure
