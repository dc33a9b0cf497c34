#include "scenes/frame_all.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>

#include "scenes/scene_error.h"

namespace zproof {
namespace {

constexpr double framing_yfov = std::numbers::pi / 4;
constexpr double margin = 1.05;                          ///< air around the bounds
constexpr std::size_t triangles_worth_a_task = 1 << 12;  ///< triangles
const glm::dvec3 towards_eye = glm::normalize(glm::dvec3(0.5, 0.35, 1));

/// A vertex and whatever follows it in memory, side by side.
typedef float Lanes __attribute__((vector_size(16)));

static_assert(sizeof(glm::vec3) + Positions::allocator_type::padding >= sizeof(Lanes));

Lanes lanes_of(const glm::vec3& position) {
    Lanes lanes;
    std::memcpy(&lanes, &position, sizeof lanes);
    return lanes;
}

Lanes least(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
Lanes most(const Lanes& a, const Lanes& b) { return a > b ? a : b; }

struct Bounds {
    Lanes low{INFINITY, INFINITY, INFINITY}, high = -low;

    void join(const Lanes& least_of, const Lanes& most_of) {
        low = least(low, least_of);
        high = most(high, most_of);
    }
};

/// The bounds of every vertex that one of the triangles uses.
Bounds bounds_of(const Positions& position, std::span<const glm::uvec3> triangles) {
    Bounds bounds;
    for (const glm::uvec3& t : triangles) {
        const Lanes a = lanes_of(position[t.x]), b = lanes_of(position[t.y]), c = lanes_of(position[t.z]);
        bounds.join(least(least(a, b), c), most(most(a, b), c));
    }
    return bounds;
}

Bounds bounds_of(const Scene& scene) {
    const std::span<const glm::uvec3> triangles = scene.triangles;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, triangles.size(), triangles_worth_a_task), Bounds{},
        [&](const auto& some, Bounds bounds) {
            const Bounds more =
                bounds_of(scene.vertices.position_world, triangles.subspan(some.begin(), some.size()));
            bounds.join(more.low, more.high);
            return bounds;
        },
        [](Bounds bounds, const Bounds& more) {
            bounds.join(more.low, more.high);
            return bounds;
        });
}

/// The eight corners of the scene's bounds.
std::array<glm::dvec3, 8> corners_of_bounds(const Scene& scene) {
    const auto [low, high] = bounds_of(scene);
    std::array<glm::dvec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i)
        corners[i] = {(i & 1 ? high : low)[0], (i & 2 ? high : low)[1], (i & 4 ? high : low)[2]};
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
        camera.window = symmetric_window(framing_yfov, aspect);
        return camera;
    }
    const std::array<glm::dvec3, 8> corners = corners_of_bounds(scene);
    const glm::dvec3 centre = corners[0] / 2.0 + corners[7] / 2.0;
    Camera camera = look_at(towards_eye, {0, 0, 0}, {0, 1, 0});
    camera.window = symmetric_window(framing_yfov, aspect);
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
