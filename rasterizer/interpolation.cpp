#include "rasterizer/interpolation.h"

#include <tbb/parallel_for.h>

#include "rasterizer/surface.h"

namespace zproof::rasterizer {

namespace {

/// What the weights of a perspective become where depth is forgotten: each is multiplied by its corner's
/// depth.
Barycentrics affine(Barycentrics b, const Camera& camera, const std::array<glm::dvec3, 3>& from_eye) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += b[i] *= -glm::dot(camera.back, from_eye[i]);
    for (double& weight : b) weight /= sum;
    return b;
}

template <class Value>
std::array<Value, 3> at_corners(const auto& attribute, const glm::uvec3& t) {
    return {Value(attribute[t.x]), Value(attribute[t.y]), Value(attribute[t.z])};
}

}  // namespace

Attributes attributes_of(const Scene& scene, const View& view, const Frame& frame,
                         Interpolation interpolation) {
    const bool has_uv = !scene.vertices.uv.empty();
    Attributes found{.barycentric = Plane<std::array<float, 2>>(frame.size()),
                     .uv = Plane<std::array<float, 2>>(has_uv ? frame.size() : Resolution{}),
                     .position_world = Plane<std::array<float, 3>>(frame.size())};
    const bool is_affine =
        interpolation == Interpolation::affine && view.camera.projection == Projection::perspective;
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const glm::uvec3& t = scene.triangles[std::size_t(id)];
            const auto p = at_corners<glm::dvec3>(scene.vertices.position_world, t);
            const glm::dvec3 eye{view.camera.eye_world};
            const std::array from_eye{p[0] - eye, p[1] - eye, p[2] - eye};
            Barycentrics b = barycentrics(pixel_ray(view, x + 0.5, y + 0.5), from_eye);
            if (is_affine) b = affine(b, view.camera, from_eye);
            const glm::vec3 position{blended(b, p)};
            found.barycentric.at(x, y) = {float(b[1]), float(b[2])};
            found.position_world.at(x, y) = {position.x, position.y, position.z};
            if (!has_uv) continue;
            const glm::vec2 uv{blended(b, at_corners<glm::dvec2>(scene.vertices.uv.front(), t))};
            found.uv.at(x, y) = {uv.x, uv.y};
        }
    });
    return found;
}

}  // namespace zproof::rasterizer
