#include <cstdint>

#include "measure/selfcheck/frame_mapping.h"
#include "measure/selfcheck/variants.h"

namespace zproof::measure {
namespace {

struct Ray {
    glm::dvec3 origin_world, direction_world;
};

Ray ray_at(const View& view, Pixel pixel) {
    const Camera& c = view.camera;
    const glm::dvec2 p_raster = sampled_at(view, pixel.x, pixel.y);
    const double u = c.window.left + (c.window.right - c.window.left) * p_raster.x / view.width;
    const double v = c.window.top - (c.window.top - c.window.bottom) * p_raster.y / view.height;
    const glm::dvec3 eye(c.eye_world), aside = u * c.right + v * c.up;
    if (c.projection == Projection::perspective) return {eye, aside - c.back};
    return {eye + aside, c.shear.x * c.right + c.shear.y * c.up - c.back};
}

/// Does the ray meet the triangle's plane nearer to corner b than to corner a, as weights go? In double: on
/// the cut itself either half will do.
bool meets_second_half(const Scene& scene, const glm::uvec3& t, const Ray& ray) {
    const auto from_origin = [&](std::uint32_t vertex) {
        return glm::dvec3(scene.vertices.position_world[vertex]) - ray.origin_world;
    };
    const glm::dvec3 a = from_origin(t.x), b = from_origin(t.y), c = from_origin(t.z),
                     &d = ray.direction_world;
    const double weight_a = glm::dot(d, glm::cross(b, c)), weight_b = glm::dot(d, glm::cross(c, a)),
                 weight_c = glm::dot(d, glm::cross(a, b));
    return (weight_b > weight_a) == (weight_a + weight_b + weight_c > 0);
}

}  // namespace

/// Triangle t (a, b, c) becomes 2 t (a, m, c) and 2 t + 1 (m, b, c), where m is the middle of a and b,
/// rounded to float32 and a vertex of its own. Attributes are left out.
Scene split_in_two(const Scene& scene) {
    Scene split = scene;
    split.triangles.clear();
    split.vertices = {};
    split.vertices.position_world = scene.vertices.position_world;
    Positions& positions = split.vertices.position_world;
    for (const glm::uvec3& t : scene.triangles) {
        const auto middle = std::uint32_t(positions.size());
        positions.push_back(glm::vec3(0.5 * (glm::dvec3(positions[t.x]) + glm::dvec3(positions[t.y]))));
        split.triangles.push_back({t.x, middle, t.z});
        split.triangles.push_back({middle, t.y, t.z});
    }
    for (Part& part : split.parts) {
        part.first_triangle *= 2;
        part.triangle_count *= 2;
    }
    return split;
}

std::vector<VariantPicture> pictures_of_halves(const Scene& scene, const View& view) {
    const auto half_at = [&scene, view](PrimitiveId id, Pixel pixel) {
        const auto triangle = std::uint32_t(id);
        if (triangle >= scene.triangles.size()) return PrimitiveId{0xFFFF'FFFE};  // none of this scene either
        const bool second = meets_second_half(scene, scene.triangles[triangle], ray_at(view, pixel));
        return PrimitiveId(2 * triangle + (second ? 1 : 0));
    };
    const auto expected = [half_at](const Frame& original) {
        return mapped_frame(
            original, original.size(),
            [](int x, int y) {
                return Pixel{x, y};
            },
            half_at);
    };
    return {{view, view, [](const Frame& rendered) { return rendered; }, expected}};
}

}  // namespace zproof::measure
