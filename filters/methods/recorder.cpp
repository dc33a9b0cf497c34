#include "filters/methods/recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zproof::texture {

namespace {

/// Texels from the first to the last that counts, along an axis.
struct TexelRange {
    int first = 0, last = -1;

    void include(int texel) {
        if (last < first) first = last = texel;
        first = std::min(first, texel);
        last = std::max(last, texel);
    }
    int size() const { return last - first + 1; }
};

/// Weights of the texels of level 0 that shares reach, from rectangles: differences along both axes, added up
/// at the end.
class Canvas {
  public:
    explicit Canvas(std::span<const Share> shares) {
        for (const Share& share : shares) {
            columns_.include(share.column), columns_.include(share.column + share.columns - 1);
            rows_.include(share.row), rows_.include(share.row + share.rows - 1);
        }
        steps_.resize(std::size_t(columns_.size() + 1) * std::size_t(rows_.size() + 1));
        for (const Share& share : shares) add(share);
        add_up();
    }

    const TexelRange& columns() const { return columns_; }
    const TexelRange& rows() const { return rows_; }
    double at(int column, int row) const { return steps_[index_of(column, row)]; }

  private:
    std::size_t index_of(int column, int row) const {
        return std::size_t(row - rows_.first) * std::size_t(columns_.size() + 1) +
               std::size_t(column - columns_.first);
    }
    double& step(int column, int row) { return steps_[index_of(column, row)]; }

    void add(const Share& share) {
        const int right = share.column + share.columns, below = share.row + share.rows;
        step(share.column, share.row) += share.weight;
        step(right, share.row) -= share.weight;
        step(share.column, below) -= share.weight;
        step(right, below) += share.weight;
    }

    /// Turns differences into weights.
    void add_up() {
        for (int row = rows_.first; row <= rows_.last; ++row)
            for (int column = columns_.first + 1; column <= columns_.last; ++column)
                step(column, row) += step(column - 1, row);
        for (int row = rows_.first + 1; row <= rows_.last; ++row)
            for (int column = columns_.first; column <= columns_.last; ++column)
                step(column, row) += step(column, row - 1);
    }

    TexelRange columns_, rows_;
    std::vector<double> steps_;
};

/// Moves a texel of a repeated axis to where it is nearest to the footprint's centre; other axes leave it.
struct Unwrap {
    Wrap wrap;
    int size;
    double centre;

    int operator()(int texel) const {
        if (wrap != Wrap::repeat) return texel;
        return texel + int(std::floor((centre - texel - 0.5) / size + 0.5)) * size;
    }
};

struct Weight {
    int column = 0, row = 0;
    double weight = 0;
};

/// The weights that count.
std::vector<Weight> weights_of(const Canvas& canvas, const BaseLevel& base_level, const glm::dvec2& centre) {
    const TexelRange &columns = canvas.columns(), &rows = canvas.rows();
    double largest = 0;
    for (int row = rows.first; row <= rows.last; ++row)
        for (int column = columns.first; column <= columns.last; ++column)
            largest = std::max(largest, std::abs(canvas.at(column, row)));
    const Unwrap column_of{base_level.addressing.u, base_level.width, centre.x},
        row_of{base_level.addressing.v, base_level.height, centre.y};
    std::vector<Weight> weights;
    for (int row = rows.first; row <= rows.last; ++row)
        for (int column = columns.first; column <= columns.last; ++column)
            if (const double weight = canvas.at(column, row); std::abs(weight) > 0x1p-40 * largest)
                weights.push_back({column_of(column), row_of(row), weight});
    return weights;
}

}  // namespace

Kernel record(const Sampler& sampler, const Footprint& footprint, const BaseLevel& base_level) {
    std::vector<Share> shares;
    for (const Tap& tap : sampler.taps(footprint))
        for (Share share : sampler.stored[std::size_t(tap.image)].made_of(tap.column, tap.row)) {
            share.weight *= tap.weight;
            shares.push_back(share);
        }
    return kernel_of(shares, base_level, footprint.centre);
}

Kernel kernel_of(std::span<const Share> shares, const BaseLevel& base_level, const glm::dvec2& centre) {
    const std::vector<Weight> weights = weights_of(Canvas{shares}, base_level, centre);
    TexelRange columns, rows;
    for (const Weight& weight : weights) columns.include(weight.column), rows.include(weight.row);
    Kernel kernel{columns.first, rows.first, columns.size(), rows.size(), {}};
    kernel.weights.resize(std::size_t(kernel.width) * std::size_t(kernel.height));
    for (const auto& [column, row, weight] : weights)
        kernel.weights[std::size_t(row - rows.first) * std::size_t(kernel.width) +
                       std::size_t(column - columns.first)] = weight;
    return kernel;
}

namespace {

/// Calls visit(texel's centre, weight) for each.
void each_weight(const Kernel& kernel, auto&& visit) {
    for (int row = 0; row < kernel.height; ++row)
        for (int column = 0; column < kernel.width; ++column)
            visit(glm::dvec2{kernel.first_column + column + 0.5, kernel.first_row + row + 0.5},
                  kernel.weights[std::size_t(row) * std::size_t(kernel.width) + std::size_t(column)]);
}

}  // namespace

KernelShape shape_of(const Kernel& kernel) {
    KernelShape shape;
    double absolute = 0, negative = 0;
    glm::dvec2 moment{0};
    each_weight(kernel, [&](const glm::dvec2& place, double weight) {
        shape.sum += weight;
        absolute += std::abs(weight);
        negative += std::max(-weight, 0.0);
        moment += weight * place;
    });
    shape.centroid = moment / shape.sum;
    each_weight(kernel, [&](const glm::dvec2& place, double weight) {
        const glm::dvec2 offset = place - shape.centroid;
        shape.covariance += weight / shape.sum * glm::outerProduct(offset, offset);
    });
    shape.negative_share = absolute > 0 ? negative / absolute : 0;
    return shape;
}

}  // namespace zproof::texture
