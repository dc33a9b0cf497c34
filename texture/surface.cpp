#include "texture/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "texture/coverage.h"

namespace zproof::texture {

namespace {

/// Convex: a triangle cut by up to four lines.
struct ConvexPart {
    std::array<glm::dvec2, 8> corners{};
    std::size_t count = 0;

    void add(const glm::dvec2& corner) { corners.at(count++) = corner; }
    glm::dvec2 after(std::size_t i) const { return corners[(i + 1) % count]; }
};

/// What lies on the positive side of a line of one coordinate.
ConvexPart cut(const ConvexPart& part, int axis, double at, double sign) {
    ConvexPart kept;
    for (std::size_t i = 0; i < part.count; ++i) {
        const glm::dvec2 a = part.corners[i], b = part.after(i);
        const double from = sign * (a[axis] - at), to = sign * (b[axis] - at);
        if (from >= 0) kept.add(a);
        if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
            glm::dvec2 between = a + (b - a) * (from / (from - to));
            between[axis] = at;
            kept.add(between);
        }
    }
    return kept;
}

/// Between two neighbouring whole numbers.
ConvexPart cell(const ConvexPart& part, int axis, double low) {
    return cut(cut(part, axis, low, 1), axis, low + 1, -1);
}

double area(const ConvexPart& part) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < part.count; ++i) {
        const glm::dvec2 a = part.corners[i] - part.corners[0], b = part.corners[i + 1] - part.corners[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

Extent extent(const ConvexPart& part, int axis) {
    Extent all{part.corners[0][axis], part.corners[0][axis]};
    for (std::size_t i = 1; i < part.count; ++i) {
        all.low = std::min(all.low, part.corners[i][axis]);
        all.high = std::max(all.high, part.corners[i][axis]);
    }
    return all;
}

/// All u at which a part reaches from the line v = low to v = low + 1.
Extent full_height(const ConvexPart& part, double low) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    Extent all{-inf, inf};
    for (const double line : {low, low + 1}) {
        Extent on{inf, -inf};
        for (std::size_t i = 0; i < part.count; ++i)
            if (part.corners[i].y == line)
                on = {std::min(on.low, part.corners[i].x), std::max(on.high, part.corners[i].x)};
        all = {std::max(all.low, on.low), std::min(all.high, on.high)};
    }
    return all;
}

/// Too wide to be walked cell by cell, or so far away that cells have no places of their own.
bool is_too_large(const Extent& all) {
    return all.high - all.low > 0x1p20 || std::max(-all.low, all.high) > 0x1p40;
}

class AreaSums {
  public:
    AreaSums(int width, int height)
        : width_{width}, height_{height}, sums_(std::size_t(width) * std::size_t(height)) {}

    void add(const SurfaceTriangle& triangle) {
        ConvexPart whole;
        for (const glm::dvec2& corner : triangle.corners) whole.add(corner);
        const double density = triangle.area_world / area(whole);
        if (!std::isfinite(density)) return;
        const Extent across = extent(whole, 0), down = extent(whole, 1);
        if (is_too_large(across) || is_too_large(down)) {
            for (double& sum : sums_) sum += triangle.area_world / double(sums_.size());
            return;
        }
        for (double row = std::floor(down.low); row < down.high; ++row)
            if (const ConvexPart band = cell(whole, 1, row); band.count >= 3)
                add_row(band, row, density, triangle.addressing);
    }
    const std::vector<double>& all() const { return sums_; }

  private:
    void add_row(const ConvexPart& band, double row, double density, const Addressing& addressing) {
        const auto line =
            sums_.begin() + wrapped(addressing.v, std::int64_t(row), height_) * std::ptrdiff_t(width_);
        const Extent across = extent(band, 0), full = full_height(band, row);
        const auto add_cells = [&](double from, double to) {
            for (double column = from; column < to; ++column)
                line[wrapped(addressing.u, std::int64_t(column), width_)] +=
                    density * area(cell(band, 0, column));
        };
        const double first = std::ceil(full.low), last = std::floor(full.high);
        if (!(first < last)) return add_cells(std::floor(across.low), across.high);
        add_cells(std::floor(across.low), first);
        const auto runs = covered({first, last}, addressing.u, width_);
        for (const Run& run : runs.all())
            for (int column = run.first; column < run.last; ++column)
                line[column] += density * run.weight * (last - first);
        add_cells(last, across.high);
    }

    int width_, height_;
    std::vector<double> sums_;
};

}  // namespace

std::vector<double> texel_weights(const std::vector<SurfaceTriangle>& surface, int width, int height) {
    AreaSums sums{width, height};
    for (const SurfaceTriangle& triangle : surface) sums.add(triangle);
    std::vector<double> weights = sums.all();
    const double largest = *std::ranges::max_element(weights);
    if (!(largest > 0)) return {};
    for (double& weight : weights) weight = std::round(weight / largest * 0x1p24) * 0x1p-24;
    return weights;
}

}  // namespace zproof::texture
