#include "texture/texels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/srgb.h"

namespace zproof::texture {

namespace {

std::array<double, 256> srgb_table() {
    std::array<double, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code) table[code] = decoded_srgb(double(code) / 255);
    return table;
}

}  // namespace

double linear_from_srgb(std::uint8_t code) {
    static const std::array<double, 256> table = srgb_table();
    return table[code];
}

glm::dvec4 Texels::linear(int column, int row) const {
    const std::size_t texel = std::size_t(row) * std::size_t(width) + std::size_t(column), at = 4 * texel;
    if (!light.empty()) return glm::dvec4{light[texel]};
    return {linear_from_srgb(rgba[at]), linear_from_srgb(rgba[at + 1]), linear_from_srgb(rgba[at + 2]),
            rgba[at + 3] / 255.0};
}

int wrapped_from_beyond(Wrap wrap, std::int64_t index, int size) {
    if (wrap == Wrap::clamp_to_edge) return index < 0 ? 0 : size - 1;
    const std::int64_t period = wrap == Wrap::repeat ? size : 2 * std::int64_t{size};
    const std::int64_t remainder = index % period, within = remainder < 0 ? remainder + period : remainder;
    return int(within < size ? within : period - 1 - within);
}

}  // namespace zproof::texture
