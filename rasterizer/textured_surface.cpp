#include "rasterizer/textured_surface.h"

#include "rasterizer/texel_map.h"

namespace zproof::rasterizer {

namespace {

double area_world(const Scene& scene, std::uint32_t triangle) {
    const glm::uvec3& corners = scene.triangles[triangle];
    const auto at = [&](int i) { return glm::dvec3{scene.vertices.position_world[corners[i]]}; };
    return glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
}

}  // namespace

texture::Surface surface_of(const Scene& scene, int image) {
    return [&scene, image] {
        std::vector<texture::SurfaceTriangle> surface;
        for (const Part& part : scene.parts) {
            const Texture& texture = scene.materials[std::size_t(part.material)].base_color;
            if (texture.image != image) continue;
            for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
                const std::uint32_t triangle = part.first_triangle + i;
                if (const auto texels = texels_of(scene, texture, triangle))
                    surface.push_back({*texels, area_world(scene, triangle), addressing_of(texture.sampler)});
            }
        }
        return surface;
    };
}

texture::FilterOptions options_for(const Scene& scene, const Texture& texture,
                                   texture::FilterOptions options) {
    options.addressing = addressing_of(texture.sampler);
    options.surface = surface_of(scene, texture.image);
    return options;
}

}  // namespace zproof::rasterizer
