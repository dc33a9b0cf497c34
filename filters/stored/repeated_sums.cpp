#include "filters/stored/repeated_sums.h"

#include <cmath>

namespace zproof::texture {

namespace {

/// How often a texel counts in the sum that is stored `beyond` texels behind it: C(beyond + order - 1, order
/// - 1).
double times_stored(int beyond, int order) {
    double product = 1;
    for (int i = 1; i < order; ++i) product = product * (beyond + i) / i;
    return product;
}

}  // namespace

RepeatedSums::RepeatedSums(const LinearImage& image, const Addressing& addressing, int order)
    : order_{order}, columns_{addressing.u, image.width, order}, rows_{addressing.v, image.height, order} {
    const int width = columns_.stored(), height = rows_.stored();
    sums_.resize(std::size_t(width) * std::size_t(height));
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const glm::dvec4 texel{image.at(wrapped(addressing.u, column, image.width),
                                            wrapped(addressing.v, row, image.height))};
            for (int c = 0; c < 4; ++c)
                sums_[index(column, row)].channels[c] = Wide(std::llrint(texel[c] / SummedArea::unit));
        }
    for (int time = 0; time < order; ++time) {
        for (int row = 0; row < height; ++row) sum_up(index(0, row), 1, width);
        for (int column = 0; column < width; ++column) sum_up(index(column, 0), std::size_t(width), height);
    }
}

void RepeatedSums::sum_up(std::size_t first, std::size_t stride, int count) {
    for (std::size_t i = 1; i < std::size_t(count); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            sums_[first + i * stride].channels[c] += sums_[first + (i - 1) * stride].channels[c];
}

glm::dvec4 RepeatedSums::sum(const std::vector<SumTerm>& columns, const std::vector<SumTerm>& rows) const {
    Units total{};
    for (const SumTerm& down : rows)
        for (const SumTerm& across : columns) {
            const Wide times = Wide(across.times) * Wide(down.times);
            for (std::size_t c = 0; c < 4; ++c)
                total.channels[c] += times * sums_[index(across.index, down.index)].channels[c];
        }
    __extension__ using Signed = __int128;
    glm::dvec4 sum;
    for (int c = 0; c < 4; ++c) sum[c] = double(Signed(total.channels[c])) * SummedArea::unit;
    return sum;
}

StoredImage RepeatedSums::stored_image(const LinearImage& image, const Addressing& addressing) const {
    StoredImage table{columns_.stored(), rows_.stored(), sizeof(Units), {}};
    if (sums_.size() > most_told) return table;
    const glm::ivec2 size{image.width, image.height};
    table.made_of = [order = order_, size, addressing](int column, int row) {
        std::vector<Share> shares;
        for (int j = 0; j <= row; ++j)
            for (int i = 0; i <= column; ++i)
                shares.push_back({wrapped(addressing.u, i, size.x), wrapped(addressing.v, j, size.y),
                                  times_stored(column - i, order) * times_stored(row - j, order)});
        return shares;
    };
    return table;
}

}  // namespace zproof::texture
