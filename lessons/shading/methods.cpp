#include "lessons/shading/methods.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "rasterizer/surface.h"

namespace zproof::study::shading {
namespace {

template <class Value>
Value mixed(const std::array<Value, 3>& at_corners, const Weights& w) {
    return w[0] * at_corners[0] + w[1] * at_corners[1] + w[2] * at_corners[2];
}

glm::dvec3 toward_eye(const View& view, const glm::dvec3& p_world) {
    const Camera& c = view.camera;
    if (c.projection == Projection::perspective) return glm::normalize(glm::dvec3(c.eye_world) - p_world);
    return glm::normalize(c.back - c.shear.x * c.right - c.shear.y * c.up);
}

/// 0 stays 0.
glm::dvec3 brought_to_unit_length(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : v;
}

double shaded_at(const View& view, const Lighting& lighting, const glm::dvec3& p_world,
                 const glm::dvec3& normal) {
    return intensity({p_world, brought_to_unit_length(normal), toward_eye(view, p_world)},
                     lighting.light_source, lighting.finish);
}

double depth_of(const View& view, const glm::dvec3& p_world) {
    return -glm::dot(view.camera.back, p_world - glm::dvec3(view.camera.eye_world));
}

}  // namespace

const char* name_of(Method method) {
    constexpr std::array names{"faceted", "Gouraud", "Phong"};
    return names[std::size_t(method)];
}

const char* name_of(Mixing mixing) { return mixing == Mixing::perspective ? "perspective" : "affine"; }

const char* name_of(Highlight highlight) { return highlight == Highlight::phong ? "Phong" : "Blinn-Phong"; }

Facet facet_of(const Scene& scene, const View& view, std::uint32_t triangle) {
    const glm::uvec3 index = scene.triangles[triangle];
    const auto& vertices = scene.vertices;
    Facet facet;
    for (int k = 0; k < 3; ++k) facet.p_world[std::size_t(k)] = glm::dvec3(vertices.position_world[index[k]]);
    const auto& p = facet.p_world;
    const glm::dvec3 normal = brought_to_unit_length(glm::cross(p[1] - p[0], p[2] - p[0]));
    facet.normal = {normal, normal, normal};
    const auto has_normal = [&](std::uint32_t v) { return vertices.normal_world[v] != glm::vec3(0); };
    if (!vertices.normal_world.empty() && has_normal(index.x) && has_normal(index.y) && has_normal(index.z))
        for (int k = 0; k < 3; ++k)
            facet.normal[std::size_t(k)] = glm::dvec3(vertices.normal_world[index[k]]);
    // The face normal points to the eye; the corner normals are turned if their sum does not agree with it.
    const glm::dvec3 eye = toward_eye(view, mixed(p, {1. / 3, 1. / 3, 1. / 3}));
    facet.face_normal = glm::dot(normal, eye) < 0 ? -normal : normal;
    const glm::dvec3 sum = facet.normal[0] + facet.normal[1] + facet.normal[2];
    if (glm::dot(sum, facet.face_normal) < 0)
        for (glm::dvec3& n : facet.normal) n = -n;
    return facet;
}

double shaded(const Facet& facet, const View& view, const Lighting& lighting, Method method,
              const Weights& weights) {
    if (method == Method::faceted)
        return shaded_at(view, lighting, mixed(facet.p_world, {1. / 3, 1. / 3, 1. / 3}), facet.face_normal);
    if (method == Method::phong)
        return shaded_at(view, lighting, mixed(facet.p_world, weights), mixed(facet.normal, weights));
    std::array<double, 3> at_corners{};
    for (std::size_t k = 0; k < 3; ++k)
        at_corners[k] = shaded_at(view, lighting, facet.p_world[k], facet.normal[k]);
    return mixed(at_corners, weights);
}

Weights rasterized_weights(const View& view, const Facet& facet, int x, int y) {
    const glm::dvec3 eye{view.camera.eye_world};
    return rasterizer::barycentrics(rasterizer::pixel_ray(view, x + 0.5, y + 0.5),
                                    {facet.p_world[0] - eye, facet.p_world[1] - eye, facet.p_world[2] - eye});
}

Weights traced_weights(const View& view, const Facet& facet, int x, int y) {
    const Camera& c = view.camera;
    const double u = c.window.left + (x + 0.5) * (c.window.right - c.window.left) / view.width;
    const double v = c.window.top - (y + 0.5) * (c.window.top - c.window.bottom) / view.height;
    const glm::dvec3 across = u * c.right + v * c.up, eye{c.eye_world};
    const bool is_perspective = c.projection == Projection::perspective;
    const glm::dvec3 origin = is_perspective ? eye : eye + across;
    const glm::dvec3 direction =
        is_perspective ? across - c.back : c.shear.x * c.right + c.shear.y * c.up - c.back;
    const auto& p = facet.p_world;
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const glm::dvec3 hit = origin + glm::dot(p[0] - origin, normal) / glm::dot(direction, normal) * direction;
    const double square = glm::dot(normal, normal);
    const auto area = [&](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::dot(glm::cross(a - hit, b - hit), normal) / square;
    };
    return {area(p[1], p[2]), area(p[2], p[0]), area(p[0], p[1])};
}

Weights in_image(const View& view, const Facet& facet, const Weights& weights) {
    if (view.camera.projection == Projection::parallel) return weights;
    Weights scaled{};
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += scaled[k] = weights[k] * depth_of(view, facet.p_world[k]);
    for (double& w : scaled) w /= sum;
    return scaled;
}

Plane<double> picture(const Scene& scene, const View& view, const Frame& frame, const Lighting& lighting,
                      const Technique& technique) {
    Plane<double> result(frame.size(), std::numeric_limits<double>::quiet_NaN());
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const Facet facet = facet_of(scene, view, std::uint32_t(id));
            const Weights place = technique.rule(view, facet, x, y);
            result.at(x, y) =
                shaded(facet, view, lighting, technique.method,
                       technique.mixing == Mixing::affine ? in_image(view, facet, place) : place);
        }
    });
    return result;
}

}  // namespace zproof::study::shading
