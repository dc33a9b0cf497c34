#include "oracle/povray/texture.h"

#include <algorithm>
#include <cmath>

#include "image_io/image_io.h"
#include "oracle/oracle_error.h"
#include "texture/texels.h"

namespace zproof::oracle {
namespace {

constexpr int most_images = 16, most_texels = 32768;

texture::Wrap wrap_of(Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return texture::Wrap::clamp_to_edge;
    return wrap == Wrap::repeat ? texture::Wrap::repeat : texture::Wrap::mirrored_repeat;
}

/// A neighbour more on either side, for interpolation.
UnrolledAxis unrolled(Wrap wrap, int size, double lowest, double highest) {
    if (wrap == Wrap::repeat) return {0, size, size};
    if (!(highest - lowest <= most_images) || std::max(std::abs(lowest), std::abs(highest)) > 1e6)
        throw OracleError("POV-Ray's pictures: texture coordinates from " + std::to_string(lowest) + " to " +
                          std::to_string(highest) + " on an axis that clamps or mirrors; at most 16 images");
    const int first = int(std::floor(lowest * size)) - 1, last = int(std::ceil(highest * size)) + 1;
    return {first, last - first, size};
}

std::uint16_t code_of(double value) {
    return std::uint16_t(std::lround(65535 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

PovrayTexture povray_texture(const Scene& scene, const Material& material, const UvRange& range) {
    const Texture& texture = material.base_color;
    const Image& image = scene.images[std::size_t(texture.image)];
    const Sampler& sampler = texture.sampler;
    PovrayTexture made{unrolled(sampler.wrap_u, image.width, range.lowest.x, range.highest.x),
                       unrolled(sampler.wrap_v, image.height, range.lowest.y, range.highest.y),
                       {}};
    if (std::max(made.u.count, made.v.count) > most_texels)
        throw OracleError("POV-Ray's pictures: image '" + image.name + "' is repeated to " +
                          std::to_string(made.u.count) + " x " + std::to_string(made.v.count) +
                          " texels; at most " + std::to_string(most_texels) + " on either side");
    Plane<Rgb16> unrolled_image({made.u.count, made.v.count});
    const texture::Texels texels{image.width, image.height, image.texels, image.light};
    for (int row = 0; row < made.v.count; ++row)
        for (int column = 0; column < made.u.count; ++column) {
            const int x = made.u.first + column, y = made.v.first + row;
            const glm::dvec3 colour =
                glm::dvec3(texels.linear(texture::wrapped(wrap_of(sampler.wrap_u), x, image.width),
                                         texture::wrapped(wrap_of(sampler.wrap_v), y, image.height))) *
                glm::dvec3(material.base_color_factor);
            unrolled_image.at(column, row) = {code_of(colour.r), code_of(colour.g), code_of(colour.b)};
        }
    const std::vector<std::byte> png = encode_png(unrolled_image);
    made.png.assign(reinterpret_cast<const char*>(png.data()), png.size());
    return made;
}

}  // namespace zproof::oracle
