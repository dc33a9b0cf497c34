#include "tests/frozen/true_depth.h"

#include <array>
#include <optional>

namespace zproof::frozen {
namespace {

/// Camera space: p(t) = origin + t direction, t = camera depth (scenes/camera.h).
struct TrueRay {
    glm::dvec3 origin, direction;
};

TrueRay true_ray(const View& view, const glm::dvec2& p_raster) {
    const Camera& c = view.camera;
    const double u = c.window.left + (c.window.right - c.window.left) * p_raster.x / view.width;
    const double v = c.window.top - (c.window.top - c.window.bottom) * p_raster.y / view.height;
    if (c.projection == Projection::perspective) return {{0, 0, 0}, {u, v, -1}};
    return {{u, v, 0}, {c.shear.x, c.shear.y, -1}};
}

double determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a, glm::cross(b, c));
}

/// Where a view ray meets a triangle's plane.
struct Meeting {
    double depth;
    glm::dvec3 weights;  ///< of the corners, times a common factor
    bool is_inside() const {
        const glm::dvec3& w = weights;
        return (w.x >= 0 && w.y >= 0 && w.z >= 0) || (w.x <= 0 && w.y <= 0 && w.z <= 0);
    }
};

std::optional<Meeting> meeting(const Scene& scene, const View& view, std::size_t triangle,
                               const TrueRay& line) {
    const Camera& c = view.camera;
    std::array<glm::dvec3, 3> p;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 p_world{scene.vertices.position_world[scene.triangles[triangle][k]]};
        const glm::dvec3 from_eye = p_world - glm::dvec3(c.eye_world);
        p[std::size_t(k)] =
            glm::dvec3{glm::dot(from_eye, c.right), glm::dot(from_eye, c.up), glm::dot(from_eye, c.back)} -
            line.origin;
    }
    const glm::dvec3& d = line.direction;
    const glm::dvec3 weights{determinant(d, p[1], p[2]), determinant(p[0], d, p[2]),
                             determinant(p[0], p[1], d)};
    const double depth = determinant(p[0], p[1], p[2]) / (weights.x + weights.y + weights.z);
    if (!(depth > 0 && depth < 1e30)) return std::nullopt;
    return Meeting{depth, weights};
}

}  // namespace

float depth_at(const Scene& scene, const View& view, PrimitiveId triangle, const glm::dvec2& p_raster) {
    const auto met = meeting(scene, view, std::size_t(triangle), true_ray(view, p_raster));
    return met ? float(met->depth) : 1.0f;
}

void set_true_depths(const Scene& scene, const View& view, Frame& frame) {
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x)
            if (const PrimitiveId id = frame.primitive.at(x, y); id != PrimitiveId::none)
                frame.camera_depth.at(x, y) = depth_at(scene, view, id, {x + 0.5, y + 0.5});
}

PrimitiveId seen_at(const Scene& scene, const View& view, const glm::dvec2& p_raster) {
    const TrueRay line = true_ray(view, p_raster);
    PrimitiveId seen = PrimitiveId::none;
    double nearest = view.camera.far_depth;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const auto met = meeting(scene, view, t, line);
        if (!met || !met->is_inside() || met->depth < view.camera.near_depth || met->depth > nearest)
            continue;
        if (met->depth == nearest && seen != PrimitiveId::none) continue;
        nearest = met->depth;
        seen = PrimitiveId(std::uint32_t(t));
    }
    return seen;
}

std::vector<PrimitiveId> all_at(const Scene& scene, const View& view, const glm::dvec2& p_raster) {
    const TrueRay line = true_ray(view, p_raster);
    std::vector<PrimitiveId> all;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
        const auto met = meeting(scene, view, t, line);
        if (met && met->is_inside()) all.push_back(PrimitiveId(std::uint32_t(t)));
    }
    return all;
}

}  // namespace zproof::frozen
