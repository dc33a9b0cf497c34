#include "rasterizer/texturing.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "math/srgb.h"
#include "rasterizer/textured_surface.h"
#include "rasterizer/triangle_footprints.h"

namespace zproof::rasterizer {

namespace {

using texture::Decoding;

/// One sampler per material; none where it has no texture.
std::vector<std::optional<texture::Sampler>> prepared(const Scene& scene, const Texturing& texturing) {
    std::vector<std::optional<texture::Sampler>> samplers(scene.materials.size());
    for (std::size_t i = 0; i < samplers.size(); ++i) {
        const Texture& texture = scene.materials[i].base_color;
        if (texture.image == Texture::none) continue;
        const Image& image = scene.images[std::size_t(texture.image)];
        const texture::Texels texels{image.width, image.height, image.texels, image.light};
        const auto options = options_for(scene, texture, texturing.options);
        samplers[i] = texturing.method.prepare(options.decoding == Decoding::after_filtering
                                                   ? texture::image_of_codes(texels)
                                                   : texture::linear_image(texels),
                                               options);
    }
    return samplers;
}

/// Pixels of a row that show one material, to be looked up together.
struct Run {
    const Material* material = nullptr;
    std::vector<int> columns{};
    std::vector<texture::Footprint> seen{};
    std::vector<glm::dvec4> filtered{};
};

glm::dvec4 decoded(const glm::dvec4& codes) {
    return {decoded_srgb(codes.r), decoded_srgb(codes.g), decoded_srgb(codes.b), codes.a};
}

LinearRgb rgb(const glm::dvec4& colour) { return {float(colour.r), float(colour.g), float(colour.b)}; }

/// Reads a row of pixels; a run of one triangle finds its footprints once, a run of one material is looked up
/// at once.
class Reader {
  public:
    Reader(const Scene& scene, const View& view, const Texturing& texturing)
        : scene_(scene), view_(view), texturing_(texturing), samplers_(prepared(scene, texturing)) {}

    void read_row(int y, std::span<const PrimitiveId> ids, std::span<LinearRgb> colours) const {
        PrimitiveId mapped = PrimitiveId::none;
        std::optional<TriangleFootprints> footprints;
        Run run;
        for (int x = 0; x < int(ids.size()); ++x) {
            const PrimitiveId id = ids[std::size_t(x)];
            if (id == PrimitiveId::none) continue;
            if (id != mapped || texturing_.uv == UvInterpolation::affine)
                footprints = footprints_at(std::uint32_t(id), x, y);
            mapped = id;
            const Material& material = material_of(scene_, std::uint32_t(id));
            colours[std::size_t(x)] = rgb(glm::dvec4{material.base_color_factor});
            if (!footprints) continue;
            if (&material != run.material) look_up(run, colours);
            run.material = &material;
            run.columns.push_back(x);
            run.seen.push_back(footprints->at(x, y, texturing_.derivatives));
        }
        look_up(run, colours);
    }

  private:
    std::optional<TriangleFootprints> footprints_at(std::uint32_t id, int x, int y) const {
        if (texturing_.uv == UvInterpolation::perspective) return footprints_of(scene_, view_, id);
        const auto map = affine_texels_from_raster(scene_, view_, id, {x + 0.5, y + 0.5});
        if (!map) return {};
        return TriangleFootprints{*map, RayCones{view_, *textured_corners(scene_, view_, id)}};
    }

    /// Leaves the run empty.
    void look_up(Run& run, std::span<LinearRgb> colours) const {
        if (run.seen.empty()) return;
        const auto& sampler = samplers_[std::size_t(run.material - scene_.materials.data())];
        run.filtered.resize(run.seen.size());
        texture::look_up(*sampler, run.seen, run.filtered);
        const glm::dvec4 factor{run.material->base_color_factor};
        for (std::size_t i = 0; i < run.seen.size(); ++i)
            colours[std::size_t(run.columns[i])] = rgb(factor * light(run.filtered[i]));
        run.columns.clear();
        run.seen.clear();
    }

    glm::dvec4 light(const glm::dvec4& filtered) const {
        return texturing_.options.decoding == Decoding::after_filtering ? decoded(filtered) : filtered;
    }

    const Scene& scene_;
    const View& view_;
    const Texturing& texturing_;
    std::vector<std::optional<texture::Sampler>> samplers_;
};

}  // namespace

Picture filtered(const Scene& scene, const View& view, const Frame& frame, const Texturing& texturing) {
    const Reader reader{scene, view, texturing};
    Picture picture{frame.size()};
    tbb::parallel_for(tbb::blocked_range<int>{0, view.height}, [&](const tbb::blocked_range<int>& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y)
            reader.read_row(y, frame.primitive.row(y), picture.row(y));
    });
    return picture;
}

}  // namespace zproof::rasterizer
