#include <tbb/parallel_for.h>

#include "filters/conformance/filter_precision_presets.h"
#include "filters/reference/filter_peers.h"
#include "frame/frame_error.h"
#include "image_io/texture_system.h"
#include "math/mixed.h"
#include "oracle/oracle_error.h"
#include "oracle/scratch_folder.h"

namespace zproof::oracle {

namespace {

using filter_reference::PixelFootprint;
using filter_reference::SeenTexture;

image_io::Repeat repeat_of(Wrap wrap) {
    if (wrap == Wrap::repeat) return image_io::Repeat::repeat;
    return wrap == Wrap::clamp_to_edge ? image_io::Repeat::clamp : image_io::Repeat::mirror;
}

image_io::MipMode mip_mode_of(PeerFilter filter) {
    switch (filter) {
        case PeerFilter::bilinear:
            return image_io::MipMode::none;
        case PeerFilter::trilinear:
        case PeerFilter::stochastic_trilinear:
            return image_io::MipMode::trilinear;
        default:
            return image_io::MipMode::anisotropic;
    }
}

bool is_stochastic(PeerFilter filter) {
    return filter == PeerFilter::stochastic_trilinear || filter == PeerFilter::stochastic_anisotropic;
}

/// In [0, 1): white noise.
float random_number(std::uint32_t seed, int x, int y, int sample) {
    std::uint64_t hash = seed;
    for (const int part : {x, y, sample}) hash = mixed(hash ^ std::uint64_t(part));
    return float(hash >> 40) * 0x1p-24f;
}

/// The footprint's middles as float32, where the image is the unit square. `size` is the texture's, texels.
void set_footprint(image_io::TextureLookup& lookup, const PixelFootprint& f, const glm::dvec2& size) {
    const auto s = [&](const Interval& a) { return float(middle(a) / size.x); };
    const auto t = [&](const Interval& a) { return float(middle(a) / size.y); };
    lookup.s = s(f.centre.u), lookup.t = t(f.centre.v);
    lookup.ds_per_x = s(f.per_x.u), lookup.dt_per_x = t(f.per_x.v);
    lookup.ds_per_y = s(f.per_y.u), lookup.dt_per_y = t(f.per_y.v);
}

/// All images of a scene, by their indices.
class SceneTextures {
  public:
    explicit SceneTextures(const Scene& scene) {
        for (const Image& image : scene.images) {
            const texture::LinearImage linear =
                texture::linear_image({image.width, image.height, image.texels, image.light});
            std::vector<float> rgb;
            for (const glm::vec4& texel : linear.texels) rgb.insert(rgb.end(), {texel.r, texel.g, texel.b});
            system_.add({image.width, image.height}, rgb);
        }
    }

    glm::dvec3 read(const image_io::TextureLookup& lookup) const {
        const std::array<float, 3> rgb = system_.look_up(lookup);
        return {rgb[0], rgb[1], rgb[2]};
    }

  private:
    ScratchFolder folder_;
    image_io::TextureSystem system_{folder_.path()};
};

/// What a frame is painted with.
struct Painter {
    const Scene& scene;
    const View& view;
    const SceneTextures& textures;
    PeerFilter filter;
    const FilterSettings& settings;

    LinearRgb colour_at(int x, int y, PrimitiveId id) const {
        const Material& material = filter_reference::material_of(scene, std::uint32_t(id));
        glm::dvec3 colour{glm::vec3{material.base_color_factor}};
        if (filter_reference::is_textured(scene, material)) {
            const auto triangle = filter_reference::textured_triangle(scene, std::uint32_t(id));
            const SeenTexture seen{view, triangle, FilterPrecision{}};
            const Texture& texture = material.base_color;
            image_io::TextureLookup lookup{.texture = texture.image,
                                           .along_s = repeat_of(texture.sampler.wrap_u),
                                           .along_t = repeat_of(texture.sampler.wrap_v),
                                           .mip = mip_mode_of(filter),
                                           .max_anisotropy = settings.max_anisotropy};
            set_footprint(lookup, seen.footprint(x, y, StepRule::analytic),
                          glm::dvec2{triangle.texture_size});
            colour *= read(lookup, x, y);
        }
        return {float(colour.r), float(colour.g), float(colour.b)};
    }

  private:
    glm::dvec3 read(image_io::TextureLookup& lookup, int x, int y) const {
        if (!is_stochastic(filter)) return textures.read(lookup);
        glm::dvec3 sum{};
        for (int sample = 0; sample < settings.samples; ++sample) {
            lookup.random = random_number(settings.seed, x, y, sample);
            sum += textures.read(lookup);
        }
        return sum / double(settings.samples);
    }
};

}  // namespace

Picture openimageio_filtered(const Scene& scene, const View& view, const Frame& frame, PeerFilter filter,
                             const FilterSettings& settings) {
    try {
        const SceneTextures textures{scene};
        const Painter painter{scene, view, textures, filter, settings};
        Picture drawn{frame.size()};
        tbb::parallel_for(0, view.height, [&](int y) {
            for (int x = 0; x < view.width; ++x)
                if (const PrimitiveId id = frame.primitive.at(x, y); id != PrimitiveId::none)
                    drawn.at(x, y) = painter.colour_at(x, y, id);
        });
        return drawn;
    } catch (const FrameError& e) {
        throw OracleError(e.what());
    }
}

}  // namespace zproof::oracle
