#include "oracle/filter_law/chain.h"

namespace zproof::oracle::filter_law {

namespace {

/// What a texel of the coarser level is made of along one axis.
struct Source {
    int index = 0;
    double weight = 0;
};
using Sources = std::vector<Source>;

/// Two texels each; an odd size drops its last; a size of 1 stays.
Sources box(int coarse, int fine_size) {
    if (fine_size == 1) return {{0, 1}};
    return {{2 * coarse, 0.5}, {2 * coarse + 1, 0.5}};
}

/// The exact overlap of texel [c, c + 1) of n with the fine texels, each n / fine_size wide: integers until
/// the last quotient.
Sources polyphase(int coarse, int coarse_size, int fine_size) {
    Sources sources;
    const std::int64_t n = coarse_size, begin = std::int64_t{coarse} * fine_size,
                       end = (std::int64_t{coarse} + 1) * fine_size;
    for (std::int64_t i = begin / n; i * n < end; ++i) {
        const std::int64_t overlap = std::min((i + 1) * n, end) - std::max(i * n, begin);
        sources.push_back({int(i), double(overlap) / double(fine_size)});
    }
    return sources;
}

Sources sources_of(ChainKernel kernel, int coarse, int coarse_size, int fine_size) {
    if (kernel == ChainKernel::box) return box(coarse, fine_size);
    return polyphase(coarse, coarse_size, fine_size);
}

LawImage::Texel made_of(const LawImage& finer, const Sources& columns, const Sources& rows, double unit) {
    LawImage::Texel sum;
    glm::dvec3 size{0};
    for (const Source& row : rows) {
        for (const Source& column : columns) {
            const double w = row.weight * column.weight;
            const auto& texel = finer.at(column.index, row.index);
            sum.value += w * texel.value;
            sum.radius += std::abs(w) * texel.radius;
            size += std::abs(w) * (glm::abs(texel.value) + texel.radius);
        }
    }
    // Weights and sums of an implementation and of ours, at most 64 terms, and the stored format.
    sum.radius += (unit + 160 * 0x1p-53) * size + 0x1p-149;
    return sum;
}

LawImage halved(const LawImage& finer, const Settings& settings, double unit) {
    LawImage coarser{std::max(1, finer.width / 2), std::max(1, finer.height / 2), {}};
    coarser.texels.resize(std::size_t(coarser.width) * std::size_t(coarser.height));
    std::vector<Sources> columns;
    for (int x = 0; x < coarser.width; ++x)
        columns.push_back(sources_of(settings.kernel, x, coarser.width, finer.width));
    for (int y = 0; y < coarser.height; ++y) {
        const Sources rows = sources_of(settings.kernel, y, coarser.height, finer.height);
        for (int x = 0; x < coarser.width; ++x)
            coarser.at(x, y) = made_of(finer, columns[std::size_t(x)], rows, unit);
    }
    return coarser;
}

}  // namespace

std::vector<LawImage> chain(const texture::LinearImage& image, const Settings& settings, double texel_bits) {
    std::vector<LawImage> levels{exact_image(image)};
    while (levels.back().width > 1 || levels.back().height > 1)
        levels.push_back(halved(levels.back(), settings, std::exp2(-texel_bits)));
    return levels;
}

}  // namespace zproof::oracle::filter_law
