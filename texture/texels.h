/// Stored texels, and how coordinates beyond [0, 1] find one.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace zproof::texture {

/// glTF 2.0, sampler.wrapS and wrapT.
enum class Wrap { repeat, clamp_to_edge, mirrored_repeat };

struct Addressing {
    Wrap u = Wrap::repeat, v = Wrap::repeat;
};

/// 8-bit RGBA, colour sRGB-encoded, alpha linear; row 0 first, which is v = 0 (glTF: the upper edge).
struct Texels {
    int width = 0, height = 0;             ///< at least 1
    std::span<const std::uint8_t> rgba{};  ///< 4 * width * height
    std::span<const glm::vec4> light{};    ///< linear light, in place of the codes; empty: by the codes

    /// Linear RGBA of a texel within the image.
    glm::dvec4 linear(int column, int row) const;
};

/// The sRGB transfer function (IEC 61966-2-1): linear light of a code value / 255.
double linear_from_srgb(std::uint8_t code);

/// wrapped() of an index beyond the line.
int wrapped_from_beyond(Wrap wrap, std::int64_t index, int size);

/// The texel, 0 to size - 1, that stands at a column or row anywhere on the line.
inline int wrapped(Wrap wrap, std::int64_t index, int size) {
    return index >= 0 && index < size ? int(index) : wrapped_from_beyond(wrap, index, size);
}

}  // namespace zproof::texture
