#include "rasterizer/interpolation.h"

#include <tbb/parallel_for.h>

#include "rasterizer/surface.h"

namespace zproof::rasterizer {

namespace {

template <class Value>
std::array<Value, 3> corner_values(const auto& attribute, const glm::uvec3& t) {
    return {Value(attribute[t.x]), Value(attribute[t.y]), Value(attribute[t.z])};
}

bool scene_has(const Scene& scene, Attribute attribute) {
    if (attribute == Attribute::uv) return !scene.vertices.uv.empty();
    return attribute != Attribute::normal || !scene.vertices.normal_world.empty();
}

/// In 3 numbers, of which the attribute may have fewer.
glm::dvec3 value_of(Attribute attribute, const Scene& scene, const glm::uvec3& t, const Barycentrics& b) {
    const Vertices& vertices = scene.vertices;
    switch (attribute) {
        case Attribute::barycentrics:
            return {b[1], b[2], 0};
        case Attribute::uv:
            return {blended(b, corner_values<glm::dvec2>(vertices.uv.front(), t)), 0};
        case Attribute::position:
            return blended(b, corner_values<glm::dvec3>(vertices.position_world, t));
        case Attribute::normal: {
            const glm::dvec3 normal = blended(b, corner_values<glm::dvec3>(vertices.normal_world, t));
            const double length = glm::length(normal);
            return length > 0 ? normal / length : normal;
        }
    }
    return {};
}

}  // namespace

Attributes attributes_of(const Scene& scene, const View& view, const Frame& frame) {
    Attributes found;
    for (std::size_t c = 0; c < attribute_channels.size(); ++c)
        if (scene_has(scene, attribute_channels[c].attribute)) found.planes[c] = Plane<float>(frame.size());
    const glm::dvec3 eye{view.camera.eye_world};
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const glm::uvec3& t = scene.triangles[std::size_t(id)];
            const auto p = corner_values<glm::dvec3>(scene.vertices.position_world, t);
            const glm::dvec2 at = sampled_at(view, x, y);
            const Barycentrics b =
                barycentrics(pixel_ray(view, at.x, at.y), {p[0] - eye, p[1] - eye, p[2] - eye});
            for (std::size_t c = 0; c < attribute_channels.size(); ++c)
                if (found.has(c))
                    found.planes[c].at(x, y) = float(value_of(attribute_channels[c].attribute, scene, t,
                                                              b)[int(attribute_channels[c].axis)]);
        }
    });
    return found;
}

}  // namespace zproof::rasterizer
