#include "rasterizer/textured_corners.h"

#include "rasterizer/texel_map.h"

namespace zproof::rasterizer {

std::optional<std::array<glm::dvec2, 3>> texels_of(const Scene& scene, const Texture& texture,
                                                   std::uint32_t triangle) {
    if (std::size_t(texture.uv_set) >= scene.vertices.uv.size()) return {};
    const auto& uv = scene.vertices.uv[std::size_t(texture.uv_set)];
    const Image& image = scene.images[std::size_t(texture.image)];
    const glm::dvec2 size{image.width, image.height};
    std::array<glm::dvec2, 3> texels;
    for (int i = 0; i < 3; ++i)
        texels[std::size_t(i)] = (texture.transform.translation +
                                  texture.transform.linear * glm::dvec2{uv[scene.triangles[triangle][i]]}) *
                                 size;
    return texels;
}

std::optional<std::array<TexturedCorner, 3>> textured_corners(const Scene& scene, const View& view,
                                                              std::uint32_t triangle) {
    const Texture& texture = material_of(scene, triangle).base_color;
    if (texture.image == Texture::none) return {};
    const auto texels = texels_of(scene, texture, triangle);
    if (!texels) return {};
    std::array<TexturedCorner, 3> corners;
    for (int i = 0; i < 3; ++i)
        corners[std::size_t(i)] = {glm::dvec3{scene.vertices.position_world[scene.triangles[triangle][i]]} -
                                       glm::dvec3{view.camera.eye_world},
                                   (*texels)[std::size_t(i)]};
    return corners;
}

}  // namespace zproof::rasterizer
