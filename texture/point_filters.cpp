#include "texture/point_filters.h"

#include <cmath>

namespace zproof::texture {

namespace {

/// Texel units, kept where a 64-bit integer can hold them; what is not finite reads as 0.
double in_texels(double coordinate, int size) {
    constexpr double farthest = 0x1p52;
    const double place = coordinate * size;
    return std::abs(place) < farthest ? place : 0;
}

/// A column (or row) and its neighbour, with the share of the neighbour.
struct Pair {
    int first, second;
    double share;
};

Pair around(Wrap wrap, double coordinate, int size) {
    const double place = in_texels(coordinate, size) - 0.5, low = std::floor(place);
    const auto index = std::int64_t(low);
    return {wrapped(wrap, index, size), wrapped(wrap, index + 1, size), place - low};
}

int holding(Wrap wrap, double coordinate, int size) {
    return wrapped(wrap, std::int64_t(std::floor(in_texels(coordinate, size))), size);
}

}  // namespace

glm::dvec4 nearest(const Texels& texels, const Addressing& addressing, const glm::dvec2& uv) {
    return texels.linear(holding(addressing.u, uv.x, texels.width),
                         holding(addressing.v, uv.y, texels.height));
}

glm::dvec4 bilinear(const Texels& texels, const Addressing& addressing, const glm::dvec2& uv) {
    const Pair u = around(addressing.u, uv.x, texels.width), v = around(addressing.v, uv.y, texels.height);
    const auto row = [&](int y) {
        return glm::mix(texels.linear(u.first, y), texels.linear(u.second, y), u.share);
    };
    return glm::mix(row(v.first), row(v.second), v.share);
}

}  // namespace zproof::texture
