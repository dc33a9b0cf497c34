// OpenImageIO's TextureSystem.
#include "image_io/module/textures.h"

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>

#include <memory>
#include <stdexcept>

namespace zproof::image_io {

/// A texture system of its own, whose caches nobody else sees.
class Textures {
  public:
    Textures() {
        constexpr int level = 1, probe = 2;
        system->attribute("stochastic", level | probe);  // of lookups with a random number
    }

#if OIIO_VERSION_MAJOR < 3
    std::shared_ptr<OIIO::TextureSystem> system{
        OIIO::TextureSystem::create(false), [](OIIO::TextureSystem* s) { OIIO::TextureSystem::destroy(s); }};
#else
    std::shared_ptr<OIIO::TextureSystem> system = OIIO::TextureSystem::create(false);
#endif
    std::vector<OIIO::ustring> files;
};

namespace {

OIIO::TextureOpt::Wrap wrap_of(Repeat repeat) {
    if (repeat == Repeat::repeat) return OIIO::TextureOpt::WrapPeriodic;
    return repeat == Repeat::clamp ? OIIO::TextureOpt::WrapClamp : OIIO::TextureOpt::WrapMirror;
}

OIIO::TextureOpt options_of(const TextureLookup& lookup) {
    OIIO::TextureOpt options;
    options.swrap = wrap_of(lookup.along_s);
    options.twrap = wrap_of(lookup.along_t);
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.mipmode = lookup.mip == MipMode::anisotropic ? OIIO::TextureOpt::MipModeAniso
                      : lookup.mip == MipMode::trilinear ? OIIO::TextureOpt::MipModeTrilinear
                                                         : OIIO::TextureOpt::MipModeNoMIP;
    options.anisotropic = static_cast<decltype(options.anisotropic)>(lookup.max_anisotropy);
    options.rnd = lookup.random;
    return options;
}

}  // namespace

Textures* open_textures() { return new Textures; }
void close_textures(Textures* textures) { delete textures; }

/// A tiled float32 file with a chain of means.
int add_texture(Textures& textures, const std::string& folder, const Texels& texels) {
    const int index = int(textures.files.size());
    const std::string file = folder + "/" + std::to_string(index) + ".tx";
    const OIIO::ImageSpec spec(texels.width, texels.height, 3, OIIO::TypeFloat);
    const OIIO::ImageBuf pixels(spec, const_cast<float*>(texels.rgb));  // only read
    OIIO::ImageSpec config;
    config.set_format(OIIO::TypeFloat);
    config.attribute("maketx:filtername", "box");
    if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, pixels, file, config))
        throw std::runtime_error("makes no texture: " + OIIO::geterror());
    textures.files.emplace_back(file);
    return index;
}

std::array<float, 3> look_up(const Textures& textures, const TextureLookup& lookup) {
    OIIO::TextureOpt options = options_of(lookup);
    std::array<float, 3> rgb{};
    if (!textures.system->texture(textures.files[std::size_t(lookup.texture)], options, lookup.s, lookup.t,
                                  lookup.ds_per_x, lookup.dt_per_x, lookup.ds_per_y, lookup.dt_per_y, 3,
                                  rgb.data()))
        throw std::runtime_error(textures.system->geterror());
    return rgb;
}

}  // namespace zproof::image_io
