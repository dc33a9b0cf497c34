#include "scenes_at_random.h"

#include <cmath>

namespace zproof::oracle {
namespace {

/// Rotation about `axis` (0 x, 1 y, 2 z).
glm::dmat3 turn(int axis, double angle) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    glm::dmat3 matrix(1.0);
    matrix[i][i] = matrix[j][j] = std::cos(angle);
    matrix[i][j] = std::sin(angle);
    matrix[j][i] = -std::sin(angle);
    return matrix;
}

glm::dvec3 random_point(Rng& rng, double reach) {
    const double x = rng.between(-reach, reach), y = rng.between(-reach, reach);
    return {x, y, rng.between(-reach, reach)};
}

void orient(Camera& camera, Rng& rng) {
    const double yaw = rng.between(-3, 3), pitch = rng.between(-3, 3), roll = rng.between(-3, 3);
    const glm::dmat3 axes = turn(1, yaw) * turn(0, pitch) * turn(2, roll);
    camera.right = axes[0];
    camera.up = axes[1];
    camera.back = axes[2];
}

}  // namespace

Scene scene_of(const std::vector<glm::vec3>& corners) {
    Scene scene;
    scene.name = "soup";
    scene.vertices.position_world.assign(corners.begin(), corners.end());
    for (std::uint32_t i = 0; i + 2 < corners.size(); i += 3) scene.triangles.emplace_back(i, i + 1, i + 2);
    scene.materials.resize(1);
    scene.parts.resize(1);
    scene.parts[0].triangle_count = std::uint32_t(scene.triangles.size());
    return scene;
}

Scene random_soup(Rng& rng, const Camera& camera, int triangle_count) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < triangle_count; ++i) {
        const double size = std::exp2(rng.between(-3, 3));
        const glm::dvec3 middle = glm::dvec3(camera.eye_world) - 6.0 * camera.back + random_point(rng, 4);
        for (int corner = 0; corner < 3; ++corner) corners.emplace_back(middle + random_point(rng, size));
    }
    return scene_of(corners);
}

View random_view(Rng& rng, ProjectionKind projection_kind) {
    View view{.name = "random", .camera = {}, .width = 45, .height = 34};  // not multiples of a packet's side
    Camera& camera = view.camera;
    camera.eye_world = glm::vec3(random_point(rng, 20));
    orient(camera, rng);
    camera.near_depth = 2;
    camera.far_depth = 9;
    camera.window = {.left = -0.8, .right = 0.8, .bottom = -0.6, .top = 0.6};
    if (projection_kind == ProjectionKind::off_axis)
        camera.window = {.left = -0.2, .right = 1.1, .bottom = -0.9, .top = 0.3};
    if (projection_kind == ProjectionKind::orthographic || projection_kind == ProjectionKind::oblique) {
        camera.projection = Projection::parallel;
        camera.window = {.left = -4, .right = 4, .bottom = -3, .top = 3};
        if (rng.between(-1, 1) > 0) camera.near_depth = -1.5;
    }
    if (projection_kind == ProjectionKind::oblique)
        camera.shear = {rng.between(-0.5, 0.5), rng.between(-0.5, 0.5)};
    return view;
}

}  // namespace zproof::oracle
