// Lookups of texture filters: the worked plane of checks (tests/support/worked_setup.h) at 1920 x 1080 with a
// texture of 4096 x 4096, every pixel below the horizon; beside OpenImageIO's TextureSystem where it has the
// like.
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <tbb/parallel_for.h>

#include <filesystem>

#include "bench/lazy.h"
#include "bench/suites.h"
#include "filters/methods/catalogue.h"
#include "tests/support/footprints.h"
#include "tests/support/test_folder.h"
#include "tests/support/worked_setup.h"

namespace zproof::bench {
namespace {

using texture::Footprint;
using texture::LinearImage;

constexpr int width = 1920, height = 1080, texture_side = 4096;
constexpr int first_row = height * texture::worked::first_row / texture::worked::side;

/// The worked plane on a larger image: raster positions are scaled.
std::vector<Footprint> footprints() {
    namespace worked = texture::worked;
    Homography<double> map = worked::texels_from_raster(30);
    const double scale = double(worked::side) / height, texels = double(texture_side) / worked::texture_side;
    for (Affine<double>* f : {&map.u, &map.v, &map.w}) f->a *= scale, f->b *= scale;
    map.u = texels * map.u, map.v = texels * map.v;
    std::vector<Footprint> seen;
    for (int y = first_row; y < height; ++y)
        for (int x = 0; x < width; ++x)
            seen.push_back(texture::with_cone_of_its_steps(
                texture::footprint(map, x, y, texture::Derivatives::analytic)));
    return seen;
}

/// Calls look(footprints) for a row's worth of them at a time.
template <class Look>
void look_at_all(std::span<const Footprint> seen, const Look& look) {
    tbb::parallel_for(0, height - first_row, [&](int row) {
        look(seen.subspan(std::size_t(row) * std::size_t(width), std::size_t(width)));
    });
}

void look_up_all(std::span<const Footprint> seen, const texture::Sampler& sampler) {
    look_at_all(seen, [&](std::span<const Footprint> row) {
        std::array<glm::dvec4, width> colours;
        texture::look_up(sampler, row, colours);
        benchmark::DoNotOptimize(colours.data());
        benchmark::ClobberMemory();
    });
}

/// The texture as a tiled file with its chain of means, read through a system of our own.
class TextureSystem {
  public:
    explicit TextureSystem(const LinearImage& image)
        : file_(folder_.path() / "texture.tx"), system_(OIIO::TextureSystem::create(false)) {
        std::vector<float> rgb;
        for (const glm::vec4& texel : image.texels) rgb.insert(rgb.end(), {texel.r, texel.g, texel.b});
        const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeFloat);
        const OIIO::ImageBuf pixels(spec, rgb.data());
        OIIO::ImageSpec config;
        config.set_format(OIIO::TypeFloat);
        if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, pixels, file_.string(),
                                              config))
            throw std::runtime_error(file_.string() + ": " + OIIO::geterror());
        system_->attribute("max_memory_MB", 2048.0f);
        name_ = OIIO::ustring(file_.string());
    }
    ~TextureSystem() { OIIO::TextureSystem::destroy(system_); }
    TextureSystem(const TextureSystem&) = delete;
    TextureSystem& operator=(const TextureSystem&) = delete;

    std::array<float, 3> colour(const Footprint& seen, OIIO::TextureOpt::MipMode mode) const {
        OIIO::TextureOpt options;
        options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
        options.interpmode = OIIO::TextureOpt::InterpBilinear;
        options.mipmode = mode;
        options.anisotropic = 16;
        const auto unit = [](double texels) { return float(texels / texture_side); };
        std::array<float, 3> rgb{};
        system_->texture(name_, options, unit(seen.centre.x), unit(seen.centre.y), unit(seen.per_x.x),
                         unit(seen.per_x.y), unit(seen.per_y.x), unit(seen.per_y.y), 3, rgb.data());
        return rgb;
    }

  private:
    TestFolder folder_;
    std::filesystem::path file_;
    OIIO::TextureSystem* system_;
    OIIO::ustring name_;
};

}  // namespace

void add_filters() {
    const Lazy<std::vector<Footprint>> seen{footprints};
    const Items lookups{"lookups", double(width) * (height - first_row)};
    const Lazy<LinearImage> image{[] { return texture::random_image(texture_side, texture_side, 1); }};
    for (const texture::Method& method : texture::methods()) {
        const Lazy<texture::Sampler> sampler{[=] { return method.prepare(*image, {}); }};
        add(
            "filters/" + method.name + "/zproof", [=] { look_up_all(*seen, *sampler); }, lookups);
    }
    const Lazy<std::unique_ptr<TextureSystem>> theirs{
        [=] { return std::make_unique<TextureSystem>(*image); }};
    const auto add_peer = [&](const std::string& method, OIIO::TextureOpt::MipMode mode) {
        add(
            "filters/" + method + "/OpenImageIO",
            [=] {
                const TextureSystem& system = **theirs;
                look_at_all(*seen, [&](std::span<const Footprint> row) {
                    for (const Footprint& f : row) benchmark::DoNotOptimize(system.colour(f, mode));
                });
            },
            lookups);
    };
    add_peer("trilinear-gl", OIIO::TextureOpt::MipModeTrilinear);
    add_peer("aniso-d3d11", OIIO::TextureOpt::MipModeAniso);
}

}  // namespace zproof::bench
