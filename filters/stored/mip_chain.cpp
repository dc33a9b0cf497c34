#include "filters/stored/mip_chain.h"
#include "frame/number_text.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace zproof::texture {

namespace {

/// Adds to the share of one line in the sum.
void add(std::vector<AxisShare>& shares, int index, double weight) {
    const auto found = std::ranges::find(shares, index, &AxisShare::index);
    if (found == shares.end())
        shares.push_back({index, weight});
    else
        found->weight += weight;
}

double sinc(double x) {
    if (x == 0) return 1;
    return std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

double lanczos3(double x) { return std::abs(x) < 3 ? sinc(x) * sinc(x / 3) : 0; }

/// Times I0(4), which is the same for all.
double kaiser3(double x) {
    return std::abs(x) < 3 ? sinc(x) * std::cyl_bessel_i(0.0, 4 * std::sqrt(1 - x * x / 9)) : 0;
}

std::vector<AxisShare> windowed_shares(double (*window)(double), int index, int from, int to, Wrap wrap) {
    const double step = double(from) / to, centre = (index + 0.5) * step;
    std::vector<AxisShare> shares;
    double sum = 0;
    for (auto j = std::int64_t(std::floor(centre - 3 * step)); double(j) <= centre + 3 * step; ++j) {
        const double weight = window((double(j) + 0.5 - centre) / step);
        if (weight == 0) continue;
        add(shares, wrapped(wrap, j, from), weight);
        sum += weight;
    }
    for (AxisShare& share : shares) share.weight /= sum;
    return shares;
}

std::vector<AxisShare> polyphase_shares(int index, int from, int to) {
    const double whole = from;
    return {
        {2 * index, (to - index) / whole}, {2 * index + 1, to / whole}, {2 * index + 2, (index + 1) / whole}};
}

/// Neighbours of one weight.
struct AxisRun {
    int first = 0, count = 1;
    double weight = 0;
};
using AxisRuns = std::vector<std::vector<AxisRun>>;

AxisRuns in_runs(const AxisWeights& weights) {
    AxisRuns all;
    for (std::vector<AxisShare> line : weights) {
        std::ranges::sort(line, {}, &AxisShare::index);
        std::vector<AxisRun>& runs = all.emplace_back();
        for (const AxisShare& share : line) {
            const bool goes_on = !runs.empty() && runs.back().weight == share.weight &&
                                 runs.back().first + runs.back().count == share.index;
            if (goes_on)
                ++runs.back().count;
            else
                runs.push_back({share.index, 1, share.weight});
        }
    }
    return all;
}

LinearImage blank(std::size_t width, std::size_t height) {
    return {int(width), int(height), std::vector<glm::vec4>(width * height)};
}

}  // namespace

AxisWeights halving(int size, MipKernel kernel, Wrap wrap) {
    if (size == 1) return identity(1);
    const int half = size / 2;
    AxisWeights weights;
    for (int i = 0; i < half; ++i) {
        if (kernel == MipKernel::lanczos3 || kernel == MipKernel::kaiser3)
            weights.push_back(
                windowed_shares(kernel == MipKernel::lanczos3 ? lanczos3 : kaiser3, i, size, half, wrap));
        else if (kernel == MipKernel::polyphase && size % 2 == 1)
            weights.push_back(polyphase_shares(i, size, half));
        else
            weights.push_back({{2 * i, 0.5}, {2 * i + 1, 0.5}});
    }
    return weights;
}

AxisWeights composed(const AxisWeights& coarse, const AxisWeights& fine) {
    AxisWeights whole;
    for (const std::vector<AxisShare>& line : coarse) {
        std::vector<AxisShare>& shares = whole.emplace_back();
        for (const AxisShare& outer : line)
            for (const AxisShare& inner : fine[std::size_t(outer.index)])
                add(shares, inner.index, outer.weight * inner.weight);
    }
    return whole;
}

AxisWeights identity(int size) {
    AxisWeights weights;
    for (int i = 0; i < size; ++i) weights.push_back({{i, 1}});
    return weights;
}

LinearImage resampled(const LinearImage& image, const AxisWeights& columns, const AxisWeights& rows) {
    LinearImage result = blank(columns.size(), rows.size());
    std::vector<glm::dvec4> line(std::size_t(image.width));
    for (int row = 0; row < result.height; ++row) {
        std::ranges::fill(line, glm::dvec4{0});
        for (const AxisShare& share : rows[std::size_t(row)])
            for (int column = 0; column < image.width; ++column)
                line[std::size_t(column)] += share.weight * glm::dvec4{image.at(column, share.index)};
        for (int column = 0; column < result.width; ++column) {
            glm::dvec4 sum{0};
            for (const AxisShare& share : columns[std::size_t(column)])
                sum += share.weight * line[std::size_t(share.index)];
            result.at(column, row) = glm::vec4{sum};
        }
    }
    return result;
}

std::vector<LinearImage> mip_chain(const LinearImage& image, MipKernel kernel, const Addressing& addressing) {
    std::vector<LinearImage> levels{image};
    while (levels.back().width > 1 || levels.back().height > 1) {
        const LinearImage& finer = levels.back();
        levels.push_back(resampled(finer, halving(finer.width, kernel, addressing.u),
                                   halving(finer.height, kernel, addressing.v)));
    }
    return levels;
}

std::vector<LinearImage> mip_chain(const LinearImage& image, const FilterOptions& options) {
    if (!options.given_levels) return mip_chain(image, options.mip_kernel, options.addressing);
    std::vector<LinearImage> levels{image};
    for (const LinearImage& level : *options.given_levels) {
        const LinearImage& finer = levels.back();
        const int width = std::max(1, finer.width / 2), height = std::max(1, finer.height / 2);
        if (finer.width == 1 && finer.height == 1)
            throw MipChainError{"mip level " + std::to_string(levels.size()) +
                                " is given, behind a level of 1 x 1 texels"};
        if (level.width != width || level.height != height)
            throw MipChainError{"mip level " + std::to_string(levels.size()) + " that is given has " +
                                size_text(level.width, level.height) + " texels: expected " +
                                size_text(width, height)};
        levels.push_back(level);
    }
    return levels;
}

StoredImage stored_image(const AxisWeights& columns, const AxisWeights& rows) {
    const auto runs = std::make_shared<const std::pair<AxisRuns, AxisRuns>>(in_runs(columns), in_runs(rows));
    return {int(columns.size()), int(rows.size()), sizeof(glm::vec4), [runs](int column, int row) {
                std::vector<Share> made_of;
                for (const AxisRun& down : runs->second[std::size_t(row)])
                    for (const AxisRun& across : runs->first[std::size_t(column)])
                        made_of.push_back({across.first, down.first, across.weight * down.weight,
                                           across.count, down.count});
                return made_of;
            }};
}

std::vector<StoredImage> stored_mip_chain(const LinearImage& image, MipKernel kernel,
                                          const Addressing& addressing) {
    AxisWeights columns = identity(image.width), rows = identity(image.height);
    std::vector<StoredImage> stored{stored_image(columns, rows)};
    while (columns.size() > 1 || rows.size() > 1) {
        columns = composed(halving(int(columns.size()), kernel, addressing.u), columns);
        rows = composed(halving(int(rows.size()), kernel, addressing.v), rows);
        stored.push_back(stored_image(columns, rows));
    }
    return stored;
}

}  // namespace zproof::texture
