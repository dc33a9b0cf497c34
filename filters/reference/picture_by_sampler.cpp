#include "filters/reference/picture_by_sampler.h"

#include <algorithm>

#include "filters/reference/filter_reference.h"
#include "filters/reference/seen_texture.h"

namespace zproof::oracle {
namespace {

using filter_reference::PixelFootprint;

/// Continues the texture over pixels that show something else, from those beside them in their 2 x 2 pixels.
/// A driver may look at all four: llvmpipe's anisotropic sampler takes the differences of their places for
/// the steps, whatever steps it is given.
void complete_quads(TextureLookups& lookups) {
    const auto [width, height] = lookups.place.size();
    const auto continue_from = [&lookups](glm::ivec2 pixel, glm::ivec2 beside) {
        const glm::vec4 from = lookups.place.at(beside.x, beside.y),
                        step = lookups.steps.at(beside.x, beside.y);
        if (lookups.place.at(pixel.x, pixel.y).z != 0 || from.z == 0) return;
        const glm::vec2 way{pixel - beside};
        const glm::vec2 place = glm::vec2{from} + way.x * glm::vec2{step} + way.y * glm::vec2{step.z, step.w};
        lookups.place.at(pixel.x, pixel.y) = glm::vec4{place, 0, 0};
        lookups.steps.at(pixel.x, pixel.y) = step;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int beside_x = std::min(x ^ 1, width - 1), beside_y = std::min(y ^ 1, height - 1);
            for (const glm::ivec2 beside : {glm::ivec2{beside_x, beside_y}, {x, beside_y}, {beside_x, y}})
                continue_from({x, y}, beside);
        }
}

TextureLookups lookups_of(const Scene& scene, const View& view, const Frame& frame,
                          const Material& material) {
    TextureLookups lookups{Plane<glm::vec4>{frame.size()}, Plane<glm::vec4>{frame.size()}};
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = frame.primitive.at(x, y);
            if (id == PrimitiveId::none ||
                &filter_reference::material_of(scene, std::uint32_t(id)) != &material)
                continue;
            const auto triangle = filter_reference::textured_triangle(scene, std::uint32_t(id));
            const filter_reference::SeenTexture seen{view, triangle, FilterPrecision{}};
            const PixelFootprint f = seen.footprint(x, y, StepRule::analytic);
            const glm::dvec2 size{triangle.texture_size};
            const auto in_uv = [&](const filter_reference::TexelInterval& p) {
                return glm::vec2{glm::dvec2{middle(p.u), middle(p.v)} / size};
            };
            lookups.place.at(x, y) = glm::vec4{in_uv(f.centre), 1, 0};
            lookups.steps.at(x, y) = glm::vec4{in_uv(f.per_x), in_uv(f.per_y)};
        }
    }
    complete_quads(lookups);
    return lookups;
}

/// The pixels that show this material.
void paint(Picture& picture, const TextureLookups& lookups, const Plane<glm::vec4>& colours,
           const glm::dvec3& factor) {
    for (int y = 0; y < picture.size().height; ++y)
        for (int x = 0; x < picture.size().width; ++x) {
            if (lookups.place.at(x, y).z == 0) continue;
            const glm::dvec3 colour = factor * glm::dvec3{glm::vec3{colours.at(x, y)}};
            picture.at(x, y) = {float(colour.r), float(colour.g), float(colour.b)};
        }
}

}  // namespace

Picture picture_by_sampler(const Scene& scene, const View& view, const Frame& frame,
                           const TextureSampler& sample) {
    Picture picture{frame.size()};
    for (const Material& material : scene.materials) {
        if (!filter_reference::is_textured(scene, material)) continue;
        const Texture& texture = material.base_color;
        const TextureLookups lookups = lookups_of(scene, view, frame, material);
        paint(picture, lookups, sample(scene.images[std::size_t(texture.image)], texture.sampler, lookups),
              glm::dvec3{glm::vec3{material.base_color_factor}});
    }
    return picture;
}

}  // namespace zproof::oracle
