#include "rasterizer/shader.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <algorithm>

#include "rasterizer/surface.h"
#include "rasterizer/texel_map.h"
#include "rasterizer/textured_surface.h"
#include "texture/point_filters.h"

namespace zproof::rasterizer {

namespace {

/// A triangle and the place on it that a pixel sees.
struct Point {
    const Scene& scene;
    glm::uvec3 corners;
    const Material& material;
    Barycentrics weights;

    template <class Value>
    std::array<Value, 3> at_corners(const auto& attribute) const {
        return {Value(attribute[corners.x]), Value(attribute[corners.y]), Value(attribute[corners.z])};
    }
};

glm::dvec3 texture_colour(const Point& point) {
    const Texture& texture = point.material.base_color;
    const auto& uv_sets = point.scene.vertices.uv;
    if (texture.image == Texture::none || std::size_t(texture.uv_set) >= uv_sets.size()) return glm::dvec3{1};
    const glm::dvec2 uv =
        blended(point.weights, point.at_corners<glm::dvec2>(uv_sets[std::size_t(texture.uv_set)]));
    const glm::dvec2 place = texture.transform.translation + texture.transform.linear * uv;
    const Image& image = point.scene.images[std::size_t(texture.image)];
    const texture::Texels texels{image.width, image.height, image.texels, image.light};
    const texture::Addressing addressing = addressing_of(texture.sampler);
    const bool is_nearest = texture.sampler.magnification == Magnification::nearest;
    return glm::dvec3(is_nearest ? texture::nearest(texels, addressing, place)
                                 : texture::bilinear(texels, addressing, place));
}

glm::dvec3 base_colour(const Point& point) {
    glm::dvec3 colour = glm::dvec3(point.material.base_color_factor) * texture_colour(point);
    if (const auto& colours = point.scene.vertices.color; !colours.empty())
        colour *= glm::dvec3(blended(point.weights, point.at_corners<glm::dvec4>(colours)));
    return colour;
}

/// The normal of the vertices where all three have one, else of the triangle; not of unit length.
glm::dvec3 shading_normal_world(const Point& point) {
    const auto& normals = point.scene.vertices.normal_world;
    if (!normals.empty()) {
        const auto n = point.at_corners<glm::dvec3>(normals);
        if (std::ranges::count(n, glm::dvec3{0}) == 0) return blended(point.weights, n);
    }
    const auto p = point.at_corners<glm::dvec3>(point.scene.vertices.position_world);
    return glm::cross(p[1] - p[0], p[2] - p[0]);
}

/// Unit, turned to the viewer; zero where the triangle has no area.
glm::dvec3 normal_to_viewer_world(const Point& point, const PixelRay& line) {
    const glm::dvec3 normal = shading_normal_world(point);
    const double length = glm::length(normal);
    if (length == 0) return glm::dvec3{0};
    return normal * ((glm::dot(normal, line.to) > 0 ? -1 : 1) / length);
}

LinearRgb lit(const glm::dvec3& colour, double brightness) {
    const glm::vec3 seen{colour * brightness};
    return {seen.r, seen.g, seen.b};
}

glm::dvec3 in_world(const Camera& c, const glm::dvec3& camera) {
    return camera.x * c.right + camera.y * c.up + camera.z * c.back;
}

}  // namespace

Shader::Shader(const Scene& scene, const View& view, const Light& light)
    : scene_(scene),
      view_(view),
      light_(light),
      toward_light_world_(in_world(view.camera, light.toward_camera)) {}

LinearRgb Shader::colour_at(int x, int y, PrimitiveId primitive) const {
    const auto id = std::uint32_t(primitive);
    const glm::uvec3 corners = scene_.triangles[id];
    const auto from_eye = [&](std::uint32_t vertex) {
        return glm::dvec3{scene_.vertices.position_world[vertex]} - glm::dvec3{view_.camera.eye_world};
    };
    const glm::dvec2 at = sampled_at(view_, x, y);
    const PixelRay line = pixel_ray(view_, at.x, at.y);
    const Point point{scene_, corners, material_of(scene_, id),
                      barycentrics(line, {from_eye(corners.x), from_eye(corners.y), from_eye(corners.z)})};
    const double facing = std::max(0.0, glm::dot(normal_to_viewer_world(point, line), toward_light_world_));
    return lit(base_colour(point), light_.ambient + light_.diffuse * facing);
}

Picture shade(const Scene& scene, const View& view, const Frame& frame, const Light& light) {
    const Shader shader{scene, view, light};
    Picture picture{frame.size()};
    tbb::parallel_for(tbb::blocked_range<int>{0, view.height}, [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y)
            for (int x = 0; x < view.width; ++x)
                if (const PrimitiveId id = frame.primitive.at(x, y); id != PrimitiveId::none)
                    picture.at(x, y) = shader.colour_at(x, y, id);
    });
    return picture;
}

}  // namespace zproof::rasterizer
