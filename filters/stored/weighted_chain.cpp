#include "filters/stored/weighted_chain.h"

#include <algorithm>
#include <memory>

#include "filters/stored/mip_chain.h"

namespace zproof::texture {

namespace {

/// A texel of a level and what it counts for.
struct WeightedLevel {
    LinearImage image;
    std::vector<double> weights;

    double weight(int column, int row) const {
        return weights[std::size_t(row) * std::size_t(image.width) + std::size_t(column)];
    }
};

/// A source of a texel: its place in the finer level, and the kernel's weight.
template <class Each>
void for_each_source(const std::vector<AxisShare>& columns, const std::vector<AxisShare>& rows, Each&& each) {
    for (const AxisShare& column : columns)
        for (const AxisShare& row : rows) each(column.index, row.index, column.weight * row.weight);
}

/// The weight of a texel that is made of these; the texel is written only where they do not weigh alike.
double weigh(const WeightedLevel& finer, const std::vector<AxisShare>& columns,
             const std::vector<AxisShare>& rows, glm::vec4& texel) {
    const double first = finer.weight(columns[0].index, rows[0].index);
    bool alike = true;
    double weight = 0;
    glm::dvec4 sum{0};
    for_each_source(columns, rows, [&](int column, int row, double share) {
        const double own = finer.weight(column, row);
        alike = alike && own == first;
        weight += share * own;
        sum += share * own * glm::dvec4{finer.image.at(column, row)};
    });
    if (alike) return first;
    texel = glm::vec4{sum / weight};
    return weight;
}

WeightedLevel halved(const WeightedLevel& finer, MipKernel kernel) {
    const AxisWeights columns = halving(finer.image.width, kernel, Wrap::repeat),
                      rows = halving(finer.image.height, kernel, Wrap::repeat);
    WeightedLevel coarser{resampled(finer.image, columns, rows), {}};
    for (int row = 0; row < coarser.image.height; ++row)
        for (int column = 0; column < coarser.image.width; ++column)
            coarser.weights.push_back(weigh(finer, columns[std::size_t(column)], rows[std::size_t(row)],
                                            coarser.image.at(column, row)));
    return coarser;
}

/// A level as its texels are made of level 0.
StoredImage stored_level(const AxisWeights& columns, const AxisWeights& rows,
                         std::shared_ptr<const std::vector<double>> weights, int width) {
    const auto made_of = [columns, rows, weights = std::move(weights), width](int column, int row) {
        std::vector<Share> shares;
        double sum = 0;
        const auto own = [&](int x, int y) {
            return (*weights)[std::size_t(y) * std::size_t(width) + std::size_t(x)];
        };
        for_each_source(columns[std::size_t(column)], rows[std::size_t(row)],
                        [&](int x, int y, double share) {
                            shares.push_back({x, y, share});
                            sum += share * own(x, y);
                        });
        if (sum > 0)
            for (Share& share : shares) share.weight *= own(share.column, share.row) / sum;
        return shares;
    };
    return {int(columns.size()), int(rows.size()), sizeof(glm::vec4), made_of};
}

}  // namespace

WeightedChain::WeightedChain(const LinearImage& image, std::vector<double> weights, MipKernel kernel)
    : width_{image.width}, height_{image.height}, kernel_{kernel}, weights_{std::move(weights)} {
    WeightedLevel level{image, weights_};
    while (level.image.width > 1 || level.image.height > 1) {
        level = halved(level, kernel_);
        smaller_.push_back(level.image);
    }
}

std::vector<StoredImage> WeightedChain::stored() const {
    const auto weights = std::make_shared<const std::vector<double>>(weights_);
    AxisWeights columns = identity(width_), rows = identity(height_);
    std::vector<StoredImage> all{stored_level(columns, rows, weights, width_)};
    while (columns.size() > 1 || rows.size() > 1) {
        columns = composed(halving(int(columns.size()), kernel_, Wrap::repeat), columns);
        rows = composed(halving(int(rows.size()), kernel_, Wrap::repeat), rows);
        all.push_back(stored_level(columns, rows, weights, width_));
    }
    return all;
}

}  // namespace zproof::texture
