#include "texture/linear_image.h"

namespace zproof::texture {

LinearImage linear_image(const Texels& stored) {
    LinearImage image{stored.width, stored.height, {}};
    image.texels.reserve(std::size_t(stored.width) * std::size_t(stored.height));
    for (int row = 0; row < stored.height; ++row)
        for (int column = 0; column < stored.width; ++column)
            image.texels.emplace_back(stored.linear(column, row));
    return image;
}

LinearImage image_of_codes(const Texels& stored) {
    LinearImage image{stored.width, stored.height, {}};
    for (std::size_t at = 0; at < stored.rgba.size(); at += 4)
        image.texels.emplace_back(
            glm::dvec4{stored.rgba[at], stored.rgba[at + 1], stored.rgba[at + 2], stored.rgba[at + 3]} /
            255.0);
    return image;
}

}  // namespace zproof::texture
