#include "oracle/peers/openimageio_filter.h"

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>

#include <memory>

#include "oracle/oracle_error.h"
#include "oracle/scratch_folder.h"

namespace zproof::oracle {

namespace {

using filter_reference::PixelFootprint;
using filter_reference::SeenTexture;

[[noreturn]] void refuse(const std::string& what) { throw OracleError("OpenImageIO: " + what); }

/// A tiled float32 file with a chain of means, three channels.
void write_texture(const Image& image, const std::string& path) {
    const texture::LinearImage linear = texture::linear_image({image.width, image.height, image.texels});
    std::vector<float> rgb;
    for (const glm::vec4& texel : linear.texels) rgb.insert(rgb.end(), {texel.r, texel.g, texel.b});
    const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeFloat);
    const OIIO::ImageBuf pixels(spec, rgb.data());
    OIIO::ImageSpec config;
    config.set_format(OIIO::TypeFloat);
    config.attribute("maketx:filtername", "box");
    if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, pixels, path, config))
        refuse("makes no texture of '" + image.name + "': " + OIIO::geterror());
}

OIIO::TextureOpt::Wrap wrap_of(Wrap wrap) {
    if (wrap == Wrap::repeat) return OIIO::TextureOpt::WrapPeriodic;
    return wrap == Wrap::clamp_to_edge ? OIIO::TextureOpt::WrapClamp : OIIO::TextureOpt::WrapMirror;
}

OIIO::TextureOpt options_of(const Texture& texture, PeerFilter filter, const FilterSettings& settings) {
    OIIO::TextureOpt options;
    options.swrap = wrap_of(texture.sampler.wrap_u);
    options.twrap = wrap_of(texture.sampler.wrap_v);
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.mipmode = filter == PeerFilter::anisotropic ? OIIO::TextureOpt::MipModeAniso
                      : filter == PeerFilter::trilinear ? OIIO::TextureOpt::MipModeTrilinear
                                                        : OIIO::TextureOpt::MipModeNoMIP;
    options.anisotropic = settings.max_anisotropy;
    return options;
}

/// A texture system of our own, whose caches nobody else sees.
class Textures {
  public:
    explicit Textures(const Scene& scene)
        : system_(OIIO::TextureSystem::create(false),
                  [](OIIO::TextureSystem* s) { OIIO::TextureSystem::destroy(s); }) {
        for (std::size_t i = 0; i < scene.images.size(); ++i) {
            paths_.emplace_back((folder_.path() / (std::to_string(i) + ".tx")).string());
            write_texture(scene.images[i], paths_.back().string());
        }
    }

    /// `size` is the texture's, texels; the footprint's middles, as float32.
    glm::dvec3 read(std::size_t image, OIIO::TextureOpt options, const PixelFootprint& f,
                    const glm::dvec2& size) const {
        const auto s = [&](const Interval& a) { return float(middle(a) / size.x); };
        const auto t = [&](const Interval& a) { return float(middle(a) / size.y); };
        std::array<float, 3> rgb{};
        if (!system_->texture(paths_[image], options, s(f.centre.u), t(f.centre.v), s(f.per_x.u),
                              t(f.per_x.v), s(f.per_y.u), t(f.per_y.v), 3, rgb.data()))
            refuse(system_->geterror());
        return {rgb[0], rgb[1], rgb[2]};
    }

  private:
    ScratchFolder folder_;
    std::shared_ptr<OIIO::TextureSystem> system_;
    std::vector<OIIO::ustring> paths_;
};

}  // namespace

Picture openimageio_filtered(const Scene& scene, const View& view, const Frame& frame, PeerFilter filter,
                             const FilterSettings& settings) {
    const Textures textures{scene};
    Picture drawn{frame.size()};
    for (int y = 0; y < view.height; ++y) {
        for (int x = 0; x < view.width; ++x) {
            const PrimitiveId id = frame.primitive.at(x, y);
            if (id == PrimitiveId::none) continue;
            const Material& material = filter_reference::material_of(scene, std::uint32_t(id));
            glm::dvec3 colour{glm::vec3{material.base_color_factor}};
            if (filter_reference::is_textured(scene, material)) {
                const auto triangle = filter_reference::textured_triangle(scene, std::uint32_t(id));
                const SeenTexture seen{view, triangle, FilterPrecision{}};
                colour *= textures.read(
                    std::size_t(material.base_color.image), options_of(material.base_color, filter, settings),
                    seen.footprint(x, y, StepRule::analytic), glm::dvec2{triangle.texture_size});
            }
            drawn.at(x, y) = {float(colour.r), float(colour.g), float(colour.b)};
        }
    }
    return drawn;
}

/// A place is rounded once, then scaled and split into whole and fraction; weights, sums and texels are
/// float32.
FilterPrecision openimageio_filter_precision() {
    return {.coordinate_bits = 24,
            .weight_bits = 22,
            .tap_bits = 22,
            .sum_bits = 24,
            .sum_roundings = 80,
            .colour_bits = 22};
}

std::string openimageio_version() { return OIIO_VERSION_STRING; }

}  // namespace zproof::oracle
