#include "scenes/random/stage.h"

#include <algorithm>
#include <cmath>

#include "scenes/judged_ranges.h"
#include "scenes/random/views.h"

namespace zproof::random {
namespace {

/// Where float32 has at least 2^13 steps to the eye's distance.
double nearest_of(const Camera& camera) {
    if (camera.projection == Projection::parallel) return camera.near_depth;
    const double resolved = 0x1p-10 * largest_coordinate(camera.eye_world);
    return std::min(std::max(camera.near_depth, resolved), (camera.near_depth + camera.far_depth) / 2);
}

/// Some octaves of a perspective view: what is deeper is too small for its image to matter.
double farthest_of(const Camera& camera, double nearest, int octaves) {
    if (camera.projection == Projection::parallel) return camera.far_depth;
    return std::min(camera.far_depth, std::ldexp(nearest, octaves));
}

}  // namespace

Stage::Stage(const View& view, Random& dice, MeshBuilder& mesh)
    : view_(view),
      dice_(dice),
      mesh_(mesh),
      nearest_(nearest_of(view.camera)),
      farthest_(farthest_of(view.camera, nearest_, dice.integer(1, 8))) {}

glm::dvec3 Stage::world(const Place& place) const {
    const Camera& c = view_.camera;
    const double u = c.window.left + (c.window.right - c.window.left) * place.raster.x / view_.width,
                 v = c.window.top - (c.window.top - c.window.bottom) * place.raster.y / view_.height;
    const double t = place.depth;
    const glm::dvec3 p_camera = c.projection == Projection::perspective
                                    ? t * glm::dvec3(u, v, -1)
                                    : glm::dvec3(u + t * c.shear.x, v + t * c.shear.y, -t);
    return judged(glm::dvec3(c.eye_world) + p_camera.x * c.right + p_camera.y * c.up + p_camera.z * c.back);
}

glm::dvec3 Stage::judged(const glm::dvec3& p_world) {
    const double most = float(largest_judged_coordinate);
    return glm::clamp(p_world, -most, most);
}

glm::dvec2 Stage::raster() {
    const glm::dvec2 size(view_.width, view_.height);
    const double x = dice_.uniform(-0.25, 1.25), y = dice_.uniform(-0.25, 1.25);
    return size * glm::dvec2(x, y);
}

double Stage::depth() {
    const double linear = dice_.uniform(nearest_, farthest_);
    if (view_.camera.projection == Projection::parallel) return linear;
    return std::min(linear, nearest_ * dice_.binade(0, 7));
}

double Stage::depth_about(double depth, double share) {
    constexpr double most_slope = 32;
    const Camera& c = view_.camera;
    const bool is_parallel = c.projection == Projection::parallel;
    const double seen = std::min(c.window.right - c.window.left, c.window.top - c.window.bottom);
    const double most = most_slope * seen * (is_parallel ? 1 : depth);
    const double reach = std::min(most, share * (is_parallel ? c.far_depth - c.near_depth : depth));
    return std::clamp(depth + reach * dice_.uniform(-1, 1), nearest_, farthest_);
}

void Stage::triangle(const Corners& corners) {
    triangle({world(corners[0]), world(corners[1]), world(corners[2])});
}

void Stage::triangle(const std::array<glm::dvec3, 3>& p_world) {
    mesh_.lone_triangle({judged(p_world[0]), judged(p_world[1]), judged(p_world[2])});
}

}  // namespace zproof::random
