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

}  // namespace zproof::texture
