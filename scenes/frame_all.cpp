#include "scenes/frame_all.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "scenes/scene_error.h"

namespace zproof {
namespace {

constexpr double yfov = std::numbers::pi / 4;
constexpr double margin = 1.05;                ///< air around the bounds
constexpr std::size_t worth_a_task = 1 << 12;  ///< triangles
const glm::dvec3 towards_eye = glm::normalize(glm::dvec3(0.5, 0.35, 1));

struct Bounds {
    glm::vec3 low{INFINITY}, high{-INFINITY};

    Bounds joined(const Bounds& other) const {
        return {glm::min(low, other.low), glm::max(high, other.high)};
    }
};

/// The bounds of every vertex that one of the triangles uses.
Bounds bounds_of(const Positions& position, std::span<const glm::uvec3> triangles) {
    Bounds bounds;
    for (const glm::uvec3& t : triangles) {
        const glm::vec3 &a = position[t.x], &b = position[t.y], &c = position[t.z];
        bounds = bounds.joined({glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)});
    }
    return bounds;
}

Bounds bounds_of(const Scene& scene) {
    const std::span<const glm::uvec3> triangles = scene.triangles;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, triangles.size(), worth_a_task), Bounds{},
        [&](const auto& some, const Bounds& so_far) {
            return so_far.joined(
                bounds_of(scene.vertices.position_world, triangles.subspan(some.begin(), some.size())));
        },
        [](const Bounds& a, const Bounds& b) { return a.joined(b); });
}

/// The eight corners of the scene's bounds.
std::array<glm::dvec3, 8> corners_of_bounds(const Scene& scene) {
    const auto [low, high] = bounds_of(scene);
    std::array<glm::dvec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    return corners;
}

/// How far along the axis the eye must stand so that |x| <= u depth and |y| <= v depth for every corner.
double distance_to_fit(const std::array<glm::dvec3, 8>& corners, const glm::dvec3& centre,
                       const Camera& camera) {
    double distance = 0;
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 p = corner - centre;
        const double sideways = std::max(std::abs(glm::dot(p, camera.right)) / camera.window.right,
                                         std::abs(glm::dot(p, camera.up)) / camera.window.top);
        distance = std::max(distance, sideways + glm::dot(p, camera.back));
    }
    return distance > 0 ? distance * margin : 1;
}

/// Near and far around the corners, as seen from the eye that float32 could hold.
void enclose(const std::array<glm::dvec3, 8>& corners, Camera& camera) {
    double nearest = INFINITY, farthest = 0;
    for (const glm::dvec3& corner : corners) {
        const double depth = -glm::dot(corner - glm::dvec3(camera.eye_world), camera.back);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    if (!(nearest > 0))
        throw SceneError("frame-all: the scene is too small for its distance from the origin; add a camera");
    camera.near_depth = nearest / 2;
    camera.far_depth = farthest * 2;
}

}  // namespace

Camera frame_all(const Scene& scene, double aspect) {
    if (scene.triangles.empty()) {
        Camera camera = look_at({0, 0, 1}, {0, 0, 0}, {0, 1, 0});
        camera.window = symmetric_window(yfov, aspect);
        return camera;
    }
    const std::array<glm::dvec3, 8> corners = corners_of_bounds(scene);
    const glm::dvec3 centre = corners[0] / 2.0 + corners[7] / 2.0;
    Camera camera = look_at(towards_eye, {0, 0, 0}, {0, 1, 0});
    camera.window = symmetric_window(yfov, aspect);
    const double distance = distance_to_fit(corners, centre, camera);
    camera.eye_world = glm::vec3(centre + distance * camera.back);
    if (!std::isfinite(glm::length(glm::dvec3(camera.eye_world))))
        throw SceneError(
            "frame-all: the scene is too large to be framed in float32; add a camera or scale it down");
    enclose(corners, camera);
    validate(camera);
    return camera;
}

}  // namespace zproof
