#include "filters/methods/recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace zproof::texture {

namespace {

/// Weights of all texels of level 0, from rectangles: differences along both axes, added up at the end.
class Canvas {
  public:
    Canvas(int width, int height)
        : width_(width), height_(height), steps_(std::size_t(width + 1) * std::size_t(height + 1)) {}

    void add(const Share& share, double tap_weight) {
        const double weight = tap_weight * share.weight;
        const int right = share.column + share.columns, below = share.row + share.rows;
        at(share.column, share.row) += weight;
        at(right, share.row) -= weight;
        at(share.column, below) -= weight;
        at(right, below) += weight;
    }
    /// Turns differences into weights; to be called once.
    void add_up() {
        for (int row = 0; row < height_; ++row)
            for (int column = 1; column < width_; ++column) at(column, row) += at(column - 1, row);
        for (int row = 1; row < height_; ++row)
            for (int column = 0; column < width_; ++column) at(column, row) += at(column, row - 1);
    }
    double& at(int column, int row) {
        return steps_[std::size_t(row) * std::size_t(width_ + 1) + std::size_t(column)];
    }

  private:
    int width_, height_;
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

/// The range of the weights along an unwrapped axis: the texels from the first to the last that has one.
struct TexelRange {
    int first = 0, last = -1;

    void include(int texel) {
        if (last < first) first = last = texel;
        first = std::min(first, texel);
        last = std::max(last, texel);
    }
    int size() const { return last - first + 1; }
};

struct Weight {
    int column = 0, row = 0;
    double weight = 0;
};

/// The weights that count.
std::vector<Weight> weights_of(Canvas& canvas, const BaseLevel& base_level, const glm::dvec2& centre) {
    double largest = 0;
    for (int row = 0; row < base_level.height; ++row)
        for (int column = 0; column < base_level.width; ++column)
            largest = std::max(largest, std::abs(canvas.at(column, row)));
    const Unwrap column_of{base_level.addressing.u, base_level.width, centre.x},
        row_of{base_level.addressing.v, base_level.height, centre.y};
    std::vector<Weight> weights;
    for (int row = 0; row < base_level.height; ++row)
        for (int column = 0; column < base_level.width; ++column)
            if (const double weight = canvas.at(column, row); std::abs(weight) > 0x1p-40 * largest)
                weights.push_back({column_of(column), row_of(row), weight});
    return weights;
}

Kernel placed(Canvas& canvas, const BaseLevel& base_level, const glm::dvec2& centre) {
    canvas.add_up();
    const std::vector<Weight> weights = weights_of(canvas, base_level, centre);
    TexelRange columns, rows;
    for (const Weight& weight : weights) columns.include(weight.column), rows.include(weight.row);
    Kernel kernel{columns.first, rows.first, columns.size(), rows.size(), {}};
    kernel.weights.resize(std::size_t(kernel.width) * std::size_t(kernel.height));
    for (const auto& [column, row, weight] : weights)
        kernel.weights[std::size_t(row - rows.first) * std::size_t(kernel.width) +
                       std::size_t(column - columns.first)] = weight;
    return kernel;
}

}  // namespace

Kernel record(const Sampler& sampler, const Footprint& footprint, const BaseLevel& base_level) {
    Canvas canvas(base_level.width, base_level.height);
    for (const Tap& tap : sampler.taps(footprint))
        for (const Share& share : sampler.stored[std::size_t(tap.image)].made_of(tap.column, tap.row))
            canvas.add(share, tap.weight);
    return placed(canvas, base_level, footprint.centre);
}

Kernel kernel_of(std::span<const Share> shares, const BaseLevel& base_level, const glm::dvec2& centre) {
    Canvas canvas(base_level.width, base_level.height);
    for (const Share& share : shares) canvas.add(share, 1);
    return placed(canvas, base_level, centre);
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

glm::dmat2 footprint_covariance(const Footprint& f) {
    return (glm::outerProduct(f.per_x, f.per_x) + glm::outerProduct(f.per_y, f.per_y)) / 12.0;
}

ReadCost read_cost(const Sampler& sampler, const Footprint& footprint) {
    constexpr std::size_t line = 64;
    const std::vector<Tap> taps = sampler.taps(footprint);
    std::vector<std::pair<int, std::size_t>> texels, lines;
    for (const Tap& tap : taps) {
        const StoredImage& image = sampler.stored[std::size_t(tap.image)];
        const std::size_t index = std::size_t(tap.row) * std::size_t(image.width) + std::size_t(tap.column),
                          begin = index * image.bytes_per_texel, end = begin + image.bytes_per_texel - 1;
        texels.emplace_back(tap.image, index);
        for (std::size_t at = begin / line; at <= end / line; ++at) lines.emplace_back(tap.image, at);
    }
    const auto distinct = [](auto& list) {
        std::ranges::sort(list);
        return std::size_t(std::unique(list.begin(), list.end()) - list.begin());
    };
    return {taps.size(), distinct(texels), distinct(lines)};
}

LinearImage picture(const Kernel& kernel) {
    double largest = 0;
    for (const double weight : kernel.weights) largest = std::max(largest, std::abs(weight));
    LinearImage image{kernel.width, kernel.height, {}};
    for (const double weight : kernel.weights) {
        const auto light = float(largest > 0 ? std::abs(weight) / largest : 0);
        image.texels.emplace_back(light, weight < 0 ? 0.0f : light, weight < 0 ? 0.0f : light, 1.0f);
    }
    return image;
}

}  // namespace zproof::texture
