#include "filters/normals/normal_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scenes/filters/textures.h"

namespace zproof::normals {

NormalMap normal_map(const Image& image) {
    if (!image.light.empty())
        throw std::runtime_error("samples are floats; expected codes of 8 bits: convert it to a PNG");
    NormalMap map{image.width, image.height, {}};
    for (std::size_t i = 0; i < image.texels.size(); i += 4) {
        const glm::dvec3 code{image.texels[i], image.texels[i + 1], image.texels[i + 2]};
        const glm::dvec3 normal = 2.0 * code / 255.0 - 1.0;
        if (!(normal.z > 0))
            throw std::runtime_error("texel " + std::to_string(i / 4) +
                                     " is no normal of tangent space: its blue code is below 128");
        map.normals.push_back(glm::normalize(normal));
    }
    return map;
}

Image image_of(const NormalMap& map) {
    Image image{.name = "normals", .width = map.width, .height = map.height, .texels = {}};
    for (const glm::dvec3& normal : map.normals) {
        for (int c = 0; c < 3; ++c)
            image.texels.push_back(std::uint8_t(std::lround(255 * (normal[c] + 1) / 2)));
        image.texels.push_back(255);
    }
    return image;
}

NormalMap bumps() {
    constexpr int side = 256;
    constexpr double height = 24;  // of white above black, in texels
    const Image noise = filters::pink_noise({side, side});
    const auto at = [&](int column, int row) {
        const auto texel = std::size_t((row + side) % side * side + (column + side) % side);
        return height * noise.texels[4 * texel] / 255.0;
    };
    NormalMap map{side, side, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            map.normals.push_back(
                glm::normalize(glm::dvec3{(at(column - 1, row) - at(column + 1, row)) / 2,
                                          (at(column, row - 1) - at(column, row + 1)) / 2, 1}));
    return map;
}

FilteredImages images_to_filter(const NormalMap& map) {
    const texture::LinearImage blank{map.width, map.height, {}};
    FilteredImages images{blank, blank, blank};
    for (const glm::dvec3& n : map.normals) {
        const glm::dvec2 b = slope(n);
        images.normals.texels.emplace_back(glm::vec3{n}, 1.0f);
        images.slopes.texels.emplace_back(float(b.x), float(b.y), 0.0f, 1.0f);
        images.squares.texels.emplace_back(float(b.x * b.x), float(b.y * b.y), float(b.x * b.y), 1.0f);
    }
    return images;
}

}  // namespace zproof::normals
