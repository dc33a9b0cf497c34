#include "filters/area/surfaces.h"

#include <tbb/parallel_for.h>

namespace zproof::oracle::area {

namespace {

texture::Wrap wrap_of(Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return texture::Wrap::clamp_to_edge;
    return wrap == Wrap::repeat ? texture::Wrap::repeat : texture::Wrap::mirrored_repeat;
}

Surfaces::NearFarRange range_of(const Camera& c) {
    if (c.projection == Projection::parallel) return {-c.near_depth, -c.far_depth};
    return {1 / c.near_depth, 1 / c.far_depth};
}

SurfaceColour colour_of(const Scene& scene, const Material& material,
                        std::deque<texture::LinearImage>& images) {
    SurfaceColour colour{.factor = glm::dvec3(glm::vec3(material.base_color_factor))};
    const Texture& t = material.base_color;
    if (t.image == Texture::none || std::size_t(t.uv_set) >= scene.vertices.uv.size()) return colour;
    const Image& image = scene.images[std::size_t(t.image)];
    images.push_back(texture::linear_image({image.width, image.height, image.texels, image.light}));
    colour.image = &images.back();
    colour.addressing = {wrap_of(t.sampler.wrap_u), wrap_of(t.sampler.wrap_v)};
    return colour;
}

double brightest_of(const SurfaceColour& colour) {
    const glm::dvec3 factor = glm::abs(colour.factor);
    glm::dvec3 most{colour.image == nullptr ? 1.0 : 0.0};
    if (colour.image != nullptr)
        for (const glm::vec4& texel : colour.image->texels)
            most = glm::max(most, glm::abs(glm::dvec3{texel}));
    return std::max({factor.r * most.r, factor.g * most.g, factor.b * most.b});
}

}  // namespace

Surfaces::Surfaces(const Scene& scene, const View& view)
    : scene_(scene), seen_(scene.triangles.size()), materials_(scene.triangles.size()) {
    range_ = range_of(view.camera);
    for (const Material& material : scene.materials) {
        colours_.push_back(colour_of(scene, material, images_));
        brightest_ = std::max(brightest_, brightest_of(colours_.back()));
    }
    for (const Part& part : scene.parts)
        for (std::uint32_t i = 0; i < part.triangle_count; ++i)
            materials_[part.first_triangle + i] = part.material;
    const RasterRays<double> rays(view);
    tbb::parallel_for(std::size_t{0}, seen_.size(), [&](std::size_t i) {
        const glm::uvec3 corners = scene.triangles[i];
        const Material& material = scene.materials[std::size_t(materials_[i])];
        seen_[i] = area::seen(rays, corners_world<double>(scene, corners),
                              corner_texels<double>(scene, material, corners));
    });
}

bool Surfaces::share_an_edge(std::uint32_t a, std::uint32_t b) const {
    const auto& positions = scene_.vertices.position_world;
    int shared = 0;
    for (glm::length_t i = 0; i < 3; ++i)
        for (glm::length_t j = 0; j < 3; ++j)
            shared += positions[scene_.triangles[a][i]] == positions[scene_.triangles[b][j]];
    return shared >= 2;
}

}  // namespace zproof::oracle::area
