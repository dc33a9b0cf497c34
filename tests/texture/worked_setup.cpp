#include "worked_setup.h"

#include <cmath>
#include <numbers>

namespace zproof::texture {

namespace {

constexpr int size = 256, first_row = 56, check = 32;

using Polygon = std::vector<glm::dvec2>;

/// Sutherland-Hodgman: the part where f >= 0.
Polygon clipped(const Polygon& polygon, const Affine<double>& f) {
    Polygon part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const double at_p = f.at(p.x, p.y), at_q = f.at(q.x, q.y);
        if (at_p >= 0) part.push_back(p);
        if ((at_p < 0) != (at_q < 0)) part.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return part;
}

double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        twice += p.x * q.y - q.x * p.y;
    }
    return std::abs(twice) / 2;
}

struct Range {
    int first, last;
};

/// Checks that a polygon meets along one coordinate.
Range met(const Polygon& polygon, const Affine<double>& coordinate, const Affine<double>& w) {
    double low = 1e300, high = -1e300;
    for (const glm::dvec2& p : polygon) {
        const double at = coordinate.at(p.x, p.y) / w.at(p.x, p.y);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    return {int(std::floor(low / check)), int(std::floor(high / check))};
}

/// The part of a polygon between coordinate = k checks and (k + 1) checks.
Polygon between(const Polygon& polygon, const Affine<double>& coordinate, const Affine<double>& w, int k) {
    return clipped(clipped(polygon, coordinate - (double(k) * check) * w),
                   (double(k + 1) * check) * w - coordinate);
}

}  // namespace

Homography<double> plane_of_checks(double phi) {
    const double down = 20 * std::numbers::pi / 180, half = std::tan(30 * std::numbers::pi / 180);
    // The ray's direction (dx, dy, dz), affine in the raster position; it meets y = 0 at -1 / dy.
    const Affine<double> dx{2 * half / size, 0, -half}, up{0, -2 * half / size, half},
        dy = Affine<double>{0, 0, -std::sin(down)} + std::cos(down) * up,
        dz = Affine<double>{0, 0, std::cos(down)} + std::sin(down) * up, w = -dy;
    const double c = 128 * std::cos(phi), s = 128 * std::sin(phi);
    return {c * dx - s * dz + 3.37 * w, s * dx + c * dz + 1.71 * w, w};
}

LinearImage checks() {
    LinearImage image{512, 512, {}};
    for (int row = 0; row < 512; ++row)
        for (int column = 0; column < 512; ++column)
            image.texels.emplace_back(glm::vec4{float((column / check + row / check) % 2)});
    return image;
}

double mean_of_checks(const Homography<double>& map, int x, int y) {
    const Polygon pixel{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    double white = 0;
    const Range rows = met(pixel, map.v, map.w);
    for (int row = rows.first; row <= rows.last; ++row) {
        const Polygon strip = between(pixel, map.v, map.w, row);
        if (strip.empty()) continue;
        const Range columns = met(strip, map.u, map.w);
        for (int column = columns.first; column <= columns.last; ++column)
            if ((column + row) % 2 != 0) white += area(between(strip, map.u, map.w, column));
    }
    return white;
}

Figures figures(const Method& method, const FilterOptions& options, double phi) {
    const Sampler sampler = method.prepare(checks(), options);
    const Homography<double> map = plane_of_checks(phi);
    double squares = 0, reads = 0;
    for (int y = first_row; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Footprint seen = footprint(map, x, y, Derivatives::analytic);
            const double error = sampler.colour(seen).r - mean_of_checks(map, x, y);
            squares += error * error;
            reads += double(sampler.taps(seen).size());
        }
    constexpr double pixels = (size - first_row) * size;
    return {-10 * std::log10(squares / pixels), reads / pixels};
}

}  // namespace zproof::texture
