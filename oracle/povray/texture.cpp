#include "oracle/povray/texture.h"

#include <algorithm>
#include <cmath>

#include "oracle/oracle_error.h"
#include "texture/texels.h"

namespace zproof::oracle {
namespace {

constexpr int most_images = 16;

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

void append_channel(std::string& bytes, double value) {
    const auto code = std::uint16_t(std::lround(65535 * std::clamp(value, 0.0, 1.0)));
    bytes += char(code >> 8);
    bytes += char(code & 255);
}

}  // namespace

PovrayTexture povray_texture(const Scene& scene, const Material& material, const UvRange& range) {
    const Texture& texture = material.base_color;
    const Image& image = scene.images[std::size_t(texture.image)];
    const Sampler& sampler = texture.sampler;
    PovrayTexture made{unrolled(sampler.wrap_u, image.width, range.lowest.x, range.highest.x),
                       unrolled(sampler.wrap_v, image.height, range.lowest.y, range.highest.y),
                       {}};
    made.ppm = "P6\n" + std::to_string(made.u.count) + " " + std::to_string(made.v.count) + "\n65535\n";
    made.ppm.reserve(made.ppm.size() + 6 * std::size_t(made.u.count) * std::size_t(made.v.count));
    const texture::Texels texels{image.width, image.height, image.texels};
    for (int y = made.v.first; y < made.v.first + made.v.count; ++y)
        for (int x = made.u.first; x < made.u.first + made.u.count; ++x) {
            const glm::dvec3 colour =
                glm::dvec3(texels.linear(texture::wrapped(wrap_of(sampler.wrap_u), x, image.width),
                                         texture::wrapped(wrap_of(sampler.wrap_v), y, image.height))) *
                glm::dvec3(material.base_color_factor);
            for (const double channel : {colour.r, colour.g, colour.b}) append_channel(made.ppm, channel);
        }
    return made;
}

}  // namespace zproof::oracle
