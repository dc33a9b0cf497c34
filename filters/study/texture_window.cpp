#include "filters/study/texture_window.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace zproof::study {

namespace {

/// Texels [first, last) of an axis.
struct TexelSpan {
    double first = 0, last = 0;

    void include(double from, double to) {
        first = std::min(first, from);
        last = std::max(last, to);
    }
};

struct Bounds {
    TexelSpan columns, rows;

    explicit Bounds(const glm::dvec2& centre)
        : columns{std::floor(centre.x), std::floor(centre.x) + 1},
          rows{std::floor(centre.y), std::floor(centre.y) + 1} {}

    void include(const texture::Kernel* kernel) {
        if (kernel == nullptr || kernel->weights.empty()) return;
        columns.include(kernel->first_column, kernel->first_column + kernel->width);
        rows.include(kernel->first_row, kernel->first_row + kernel->height);
    }
};

int floor_division(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

std::vector<double> summed(const texture::Kernel* kernel, const TextureWindow& window) {
    if (kernel == nullptr) return {};
    std::vector<double> sums(std::size_t(window.width) * std::size_t(window.height));
    for (int j = 0; j < kernel->height; ++j)
        for (int i = 0; i < kernel->width; ++i) {
            const int column = (kernel->first_column + i - window.column) / window.block,
                      row = (kernel->first_row + j - window.row) / window.block;
            sums[std::size_t(row) * std::size_t(window.width) + std::size_t(column)] +=
                kernel->at(kernel->first_column + i, kernel->first_row + j);
        }
    return sums;
}

glm::vec3 mean_colour(const texture::LinearImage& image, const texture::Addressing& addressing, int column,
                      int row, int block) {
    glm::dvec3 sum{0};
    for (int j = row; j < row + block; ++j)
        for (int i = column; i < column + block; ++i)
            sum += glm::dvec3{glm::vec3{image.at(texture::wrapped(addressing.u, i, image.width),
                                                 texture::wrapped(addressing.v, j, image.height))}};
    return glm::vec3{sum / (double(block) * block)};
}

}  // namespace

std::array<glm::dvec2, 4> parallelogram(const texture::Footprint& f) {
    const glm::dvec2 u = f.per_x / 2.0, v = f.per_y / 2.0;
    return {f.centre - u - v, f.centre + u - v, f.centre + u + v, f.centre - u + v};
}

TextureWindow texture_window(const WindowContent& content, const texture::LinearImage& image,
                             const texture::Addressing& addressing, int most_cells) {
    Bounds bounds{content.footprint.centre};
    const double reach_u = image.width, reach_v = image.height;  // a period on either side shows it all
    const glm::dvec2 centre = content.footprint.centre;
    for (const glm::dvec2& corner : parallelogram(content.footprint)) {
        bounds.columns.include(std::clamp(std::floor(corner.x), centre.x - reach_u, centre.x + reach_u),
                               std::clamp(std::ceil(corner.x), centre.x - reach_u, centre.x + reach_u));
        bounds.rows.include(std::clamp(std::floor(corner.y), centre.y - reach_v, centre.y + reach_v),
                            std::clamp(std::ceil(corner.y), centre.y - reach_v, centre.y + reach_v));
    }
    bounds.include(content.read);
    bounds.include(content.exact);
    const int left = int(std::floor(bounds.columns.first)) - 1,
              right = int(std::ceil(bounds.columns.last)) + 1, top = int(std::floor(bounds.rows.first)) - 1,
              bottom = int(std::ceil(bounds.rows.last)) + 1;
    TextureWindow window;
    window.block = std::max(1, (std::max(right - left, bottom - top) + most_cells - 3) / (most_cells - 2));
    const int block = window.block;
    window.column = floor_division(left, block) * block, window.row = floor_division(top, block) * block;
    window.width = floor_division(right - 1 - window.column, block) + 1;
    window.height = floor_division(bottom - 1 - window.row, block) + 1;
    for (int row = 0; row < window.height; ++row)
        for (int column = 0; column < window.width; ++column)
            window.colour.push_back(mean_colour(image, addressing, window.column + column * block,
                                                window.row + row * block, block));
    window.read = summed(content.read, window);
    window.exact = summed(content.exact, window);
    return window;
}

}  // namespace zproof::study
