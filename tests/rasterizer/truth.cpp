#include "truth.h"

#include <array>
#include <cmath>
#include <vector>

namespace zproof::rasterizer {
namespace {

using real = long double;
using Vec3 = glm::vec<3, real>;

/// f(x, y) = value + dx x + dy y around a pixel's centre, raster units.
struct Affine {
    real value, dx, dy;

    real wobble(real reach) const { return reach * (std::abs(dx) + std::abs(dy)); }
    bool certainly_positive(real reach) const { return value > wobble(reach); }
    bool certainly_negative(real reach) const { return value < -wobble(reach); }
};

real det(const Vec3& a, const Vec3& b, const Vec3& c) { return glm::dot(a, glm::cross(b, c)); }

Vec3 to_camera(const Camera& camera, const glm::vec3& p_world) {
    const Vec3 p = Vec3(p_world) - Vec3(camera.eye_world);
    return {glm::dot(p, Vec3(camera.right)), glm::dot(p, Vec3(camera.up)), glm::dot(p, Vec3(camera.back))};
}

/// The weights of the triangle's corners on the view ray, and depth or 1 / depth ("inverse depth" below): all
/// affine.
struct TrueRay {
    std::array<Affine, 3> weight;
    Affine functional;
};

struct Window2 {
    real u, v, du, dv;
};

Window2 window_at(const View& view, int x, int y) {
    const auto& w = view.camera.window;
    const real du = (real(w.right) - w.left) / view.width, dv = -(real(w.top) - w.bottom) / view.height;
    return {w.left + du * (x + real(0.5)), w.top + dv * (y + real(0.5)), du, dv};
}

/// Solve [v0 v1 v2] b = (u, v, -1); the sum of b is 1 / depth.
TrueRay perspective_ray(const std::array<Vec3, 3>& p, const Window2& at) {
    const real volume = det(p[0], p[1], p[2]);
    TrueRay ray{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 n = glm::cross(p[(i + 1) % 3], p[(i + 2) % 3]) / volume;
        ray.weight[i] = {glm::dot(n, Vec3(at.u, at.v, -1)), n.x * at.du, n.y * at.dv};
        ray.functional.value += ray.weight[i].value;
        ray.functional.dx += ray.weight[i].dx;
        ray.functional.dy += ray.weight[i].dy;
    }
    return ray;
}

/// Slide every corner along the view ray onto the plane through the eye; barycentrics there; depth is
/// affine.
TrueRay parallel_ray(const std::array<Vec3, 3>& p, const Camera& camera, const Window2& at) {
    std::array<Vec3, 3> q;
    for (std::size_t i = 0; i < 3; ++i) {
        q[i] = {p[i].x + camera.shear.x * p[i].z, p[i].y + camera.shear.y * p[i].z, 1};
    }
    const real area = det(q[0], q[1], q[2]);
    TrueRay ray{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 n = glm::cross(q[(i + 1) % 3], q[(i + 2) % 3]) / area;
        ray.weight[i] = {glm::dot(n, Vec3(at.u, at.v, 1)), n.x * at.du, n.y * at.dv};
        ray.functional.value += ray.weight[i].value * -p[i].z;
        ray.functional.dx += ray.weight[i].dx * -p[i].z;
        ray.functional.dy += ray.weight[i].dy * -p[i].z;
    }
    return ray;
}

enum class Hit { no, yes, uncertain };

/// Inside all five half-planes for certain, outside one for certain, or neither.
Hit meets(const TrueRay& ray, const Camera& camera, real reach) {
    const Affine& f = ray.functional;
    const bool perspective = camera.projection == Projection::perspective;
    const real low = perspective ? 1 / real(camera.far_depth) : real(camera.near_depth);
    const real high = perspective ? 1 / real(camera.near_depth) : real(camera.far_depth);
    const std::array<Affine, 5> sides{ray.weight[0], ray.weight[1], ray.weight[2],
                                      Affine{f.value - low, f.dx, f.dy},
                                      Affine{high - f.value, -f.dx, -f.dy}};
    bool inside = true;
    for (const Affine& side : sides) {
        if (side.certainly_negative(reach)) return Hit::no;
        inside = inside && side.certainly_positive(reach);
    }
    return inside ? Hit::yes : Hit::uncertain;
}

struct Seen {
    PrimitiveId id;
    real depth, slope, wobble;
    Hit hit;
};

Seen seen(const Scene& scene, const View& view, std::size_t triangle, const Window2& at, real reach) {
    const Camera& camera = view.camera;
    std::array<Vec3, 3> p;
    for (int k = 0; k < 3; ++k) {
        p[std::size_t(k)] = to_camera(camera, scene.vertices.position_world[scene.triangles[triangle][k]]);
    }
    const bool perspective = camera.projection == Projection::perspective;
    const TrueRay ray = perspective ? perspective_ray(p, at) : parallel_ray(p, camera, at);
    const Affine& f = ray.functional;
    const real depth = perspective ? 1 / f.value : f.value;
    const real slope = (std::abs(f.dx) + std::abs(f.dy)) * (perspective ? depth * depth : 1);
    return {PrimitiveId(triangle), depth, slope, 2 * reach * slope + std::abs(depth) * 0x1p-22L,
            meets(ray, camera, reach)};
}

}  // namespace

std::optional<Truth> certain_truth(const Scene& scene, const View& view, int x, int y, double reach_px) {
    const Window2 at = window_at(view, x, y);
    std::vector<Seen> near_the_centre;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const Seen s = seen(scene, view, i, at, reach_px);
        if (s.hit != Hit::no) near_the_centre.push_back(s);
    }
    const Seen* nearest = nullptr;
    for (const Seen& s : near_the_centre) {
        if (s.hit == Hit::yes && (!nearest || s.depth < nearest->depth)) nearest = &s;
    }
    for (const Seen& s : near_the_centre) {
        if (&s == nearest) continue;
        const bool certainly_behind = nearest && s.depth - s.wobble > nearest->depth + nearest->wobble;
        if (!certainly_behind) return std::nullopt;
    }
    if (!nearest) return Truth{};
    return Truth{nearest->id, double(nearest->depth), double(nearest->slope)};
}

}  // namespace zproof::rasterizer
