#include "tests/reports_from_the_field/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace zproof::field_reports {

namespace {

struct Ray {
    glm::dvec3 from, along;  ///< in camera space: right, up, depth; along.z is 1
};

Ray ray_through(const View& view, const glm::dvec2& p_raster) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const double u = w.left + (w.right - w.left) * p_raster.x / view.width;
    const double v = w.top - (w.top - w.bottom) * p_raster.y / view.height;
    if (c.projection == Projection::perspective) return {{0, 0, 0}, {u, v, 1}};
    return {{u, v, 0}, {c.shear.x, c.shear.y, 1}};
}

/// Moeller and Trumbore 1997. The depth, where the ray meets the triangle.
std::optional<double> met(const Ray& ray, const CameraTriangle& t, double least_determinant) {
    const glm::dvec3 e1 = t.p_camera[1] - t.p_camera[0], e2 = t.p_camera[2] - t.p_camera[0];
    const glm::dvec3 p = cross(ray.along, e2);
    const double determinant = dot(e1, p);
    if (determinant == 0 || std::abs(determinant) < least_determinant) return std::nullopt;
    const glm::dvec3 s = ray.from - t.p_camera[0], q = cross(s, e1);
    const double a = dot(s, p) / determinant, b = dot(ray.along, q) / determinant;
    if (a < 0 || b < 0 || a + b > 1) return std::nullopt;
    return dot(e2, q) / determinant;
}

/// Depth of the triangle's plane along the ray, if its image with edges moved outwards holds the place.
std::optional<double> met_grown(const View& view, const glm::dvec2& at, const CameraTriangle& t,
                                double grown_px) {
    std::array<glm::dvec2, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = raster_position(view, t.p_camera[i]);
    const double side = double_area_px2(view, t) > 0 ? 1 : -1;
    glm::dvec2 least = p[0], most = p[0];
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 edge = p[(i + 1) % 3] - p[i], to = at - p[i];
        const double inside = side * (edge.x * to.y - edge.y * to.x);
        if (inside + grown_px * (std::abs(edge.x) + std::abs(edge.y)) < 0) return std::nullopt;
        least = min(least, p[i]);
        most = max(most, p[i]);
    }
    if (any(lessThan(at, least - grown_px)) || any(greaterThan(at, most + grown_px))) return std::nullopt;
    const Ray ray = ray_through(view, at);
    const glm::dvec3 normal = cross(t.p_camera[1] - t.p_camera[0], t.p_camera[2] - t.p_camera[0]);
    return dot(t.p_camera[0] - ray.from, normal) / dot(ray.along, normal);
}

std::vector<CameraTriangle> in_camera_space(const Scene& scene, const Camera& c) {
    std::vector<CameraTriangle> all(scene.triangles.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].id = std::uint32_t(i);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 v =
                glm::dvec3(scene.vertices.position_world[scene.triangles[i][k]]) - glm::dvec3(c.eye_world);
            all[i].p_camera[std::size_t(k)] = {dot(c.right, v), dot(c.up, v), -dot(c.back, v)};
        }
    }
    return all;
}

struct Pixels {
    int x0, y0, x1, y1;
};

/// The pixels that a triangle may show at. All of them, where a corner is not before the eye.
Pixels around(const View& view, const CameraTriangle& t) {
    const Pixels all{0, 0, view.width, view.height};
    glm::dvec2 least(1e9), most(-1e9);
    for (const glm::dvec3& p : t.p_camera) {
        if (view.camera.projection == Projection::perspective && p.z < 1e-6) return all;
        least = min(least, raster_position(view, p));
        most = max(most, raster_position(view, p));
    }
    const auto inside = [](double at, int size) { return int(std::clamp(at, 0.0, double(size))); };
    return {inside(least.x - 2, view.width), inside(least.y - 2, view.height), inside(most.x + 3, view.width),
            inside(most.y + 3, view.height)};
}

}  // namespace

glm::dvec2 raster_position(const View& view, const glm::dvec3& p) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const glm::dvec2 uv = c.projection == Projection::perspective ? glm::dvec2(p.x / p.z, p.y / p.z)
                                                                  : glm::dvec2(p) - p.z * c.shear;
    return {(uv.x - w.left) / (w.right - w.left) * view.width,
            (w.top - uv.y) / (w.top - w.bottom) * view.height};
}

double double_area_px2(const View& view, const CameraTriangle& t) {
    const glm::dvec2 p = raster_position(view, t.p_camera[0]);
    const glm::dvec2 a = raster_position(view, t.p_camera[1]) - p,
                     b = raster_position(view, t.p_camera[2]) - p;
    return a.x * b.y - a.y * b.x;
}

Frame cast(const Scene& scene, const View& view, const Habits& habits) {
    Frame frame({view.width, view.height});
    Plane<double> nearest({view.width, view.height}, view.camera.far_depth);
    for (const CameraTriangle& t : in_camera_space(scene, view.camera)) {
        if (habits.draws && !habits.draws(t)) continue;
        const Pixels pixels = habits.aims_at ? Pixels{0, 0, view.width, view.height} : around(view, t);
        for (int y = pixels.y0; y < pixels.y1; ++y)
            for (int x = pixels.x0; x < pixels.x1; ++x) {
                const glm::dvec2 at = habits.aims_at ? habits.aims_at(x, y) : sampled_at(view, x, y);
                const std::optional<double> depth =
                    habits.grown_px != 0 ? met_grown(view, at, t, habits.grown_px)
                                         : met(ray_through(view, at), t, habits.least_determinant);
                if (habits.covers && !habits.covers(t, x, y)) continue;
                const bool is_first = frame.primitive.at(x, y) == PrimitiveId::none;
                const bool is_seen =
                    depth && *depth >= view.camera.near_depth &&
                    (*depth + (is_first ? 0 : habits.lead) < nearest.at(x, y) ||
                     (*depth == nearest.at(x, y) && frame.primitive.at(x, y) == PrimitiveId::none));
                if (!is_seen) continue;
                nearest.at(x, y) = *depth;
                frame.primitive.at(x, y) = PrimitiveId(t.id);
                frame.camera_depth.at(x, y) = float(*depth);
            }
    }
    return frame;
}

}  // namespace zproof::field_reports
