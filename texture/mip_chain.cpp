#include "texture/mip_chain.h"

#include <algorithm>

namespace zproof::texture {

namespace {

LinearImage halved(const LinearImage& finer) {
    const int width = std::max(1, finer.width / 2), height = std::max(1, finer.height / 2);
    LinearImage image{width, height, std::vector<glm::vec4>(std::size_t(width) * std::size_t(height))};
    const auto texel = [&](int column, int row) {
        return glm::dvec4{finer.at(std::min(column, finer.width - 1), std::min(row, finer.height - 1))};
    };
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            image.at(column, row) =
                glm::vec4{(texel(2 * column, 2 * row) + texel(2 * column + 1, 2 * row) +
                           texel(2 * column, 2 * row + 1) + texel(2 * column + 1, 2 * row + 1)) /
                          4.0};
    return image;
}

}  // namespace

std::vector<LinearImage> mip_chain(const LinearImage& image, MipKernel) {
    std::vector<LinearImage> levels{image};
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
    return levels;
}

}  // namespace zproof::texture
