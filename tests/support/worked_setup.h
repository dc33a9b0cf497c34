/// The worked set-up that texture filters are checked against: a plane of checks of 32 texels seen to the
/// horizon, and the exact mean of every pixel. 256 x 256 pixels; eye at height 1, looking along +z pitched
/// down by 20 degrees, 60 degrees high; 128 texels per unit, turned by phi, offset by (3.37, 1.71);
/// rows 56 to 255 count.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "texture/footprint.h"
#include "texture/linear_image.h"

namespace zproof::texture::worked {

constexpr int side = 256, first_row = 56, check = 32, texture_side = 512;

/// Affine in the raster position: a view ray's three coordinates, and from them the plane's.
inline Homography<double> texels_from_raster(double phi_degrees) {
    constexpr double degree = std::numbers::pi / 180;
    const double step = 2 * std::tan(30 * degree) / side, pitch = 20 * degree, phi = phi_degrees * degree;
    const double across = -step * side / 2;  // of the ray through (0, 0); to the right is +x
    const Affine<double> x{step, 0, across}, up{0, -step, -across};
    const Affine<double> one{0, 0, 1}, y = std::cos(pitch) * up - std::sin(pitch) * one,
                                       z = std::sin(pitch) * up + std::cos(pitch) * one;
    const Affine<double> w = -y;  // the ground lies 1 below the eye: 1 / depth
    const double c = 128 * std::cos(phi), s = 128 * std::sin(phi);
    return {c * x - s * z + 3.37 * w, s * x + c * z + 1.71 * w, w};
}

inline LinearImage checks() {
    LinearImage image{texture_side, texture_side, {}};
    for (int row = 0; row < texture_side; ++row)
        for (int column = 0; column < texture_side; ++column)
            image.texels.emplace_back(glm::vec3((column / check + row / check) % 2 == 0 ? 1 : 0), 1);
    return image;
}

using Polygon = std::vector<glm::dvec2>;

/// The part where f >= 0 (Sutherland and Hodgman 1974).
inline Polygon clipped(const Polygon& polygon, const Affine<double>& f) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = f.at(p.x, p.y), at_q = f.at(q.x, q.y);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) != (at_q >= 0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return kept;
}

inline double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i] - polygon[0], q = polygon[(i + 1) % polygon.size()] - polygon[0];
        twice += p.x * q.y - p.y * q.x;
    }
    return std::abs(twice) / 2;
}

/// The bands of cells that a polygon meets along one texture axis, clipped out of it one by one.
inline void each_band(const Polygon& polygon, const Affine<double>& axis, const Affine<double>& w,
                      const std::function<void(int, const Polygon&)>& visit) {
    double low = 1e300, high = -1e300;
    for (const glm::dvec2& p : polygon) {
        const double cell = axis.at(p.x, p.y) / w.at(p.x, p.y) / check;
        low = std::min(low, cell), high = std::max(high, cell);
    }
    for (int cell = int(std::floor(low)); cell <= int(std::floor(high)); ++cell) {
        // axis / w >= k, times w > 0
        const Polygon band =
            clipped(clipped(polygon, axis - double(cell * check) * w), double((cell + 1) * check) * w - axis);
        if (band.size() > 2) visit(cell, band);
    }
}

/// The exact mean of the checks over the pixel's square, in screen space: straight lines stay straight.
inline double exact_mean(const Homography<double>& map, int x, int y) {
    const Polygon pixel{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    double white = 0;
    each_band(pixel, map.u, map.w, [&](int column, const Polygon& strip) {
        each_band(strip, map.v, map.w, [&](int row, const Polygon& cell) {
            if ((column + row) % 2 == 0) white += area(cell);
        });
    });
    return white;
}

/// Peak signal (1) to noise of a method's red channel against the exact mean, dB.
inline double psnr(double phi_degrees, const std::function<double(const Footprint&)>& red) {
    const Homography<double> map = texels_from_raster(phi_degrees);
    double squares = 0;
    for (int y = first_row; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double error = red(footprint(map, x, y, Derivatives::analytic)) - exact_mean(map, x, y);
            squares += error * error;
        }
    return -10 * std::log10(squares / (side * (side - first_row)));
}

}  // namespace zproof::texture::worked
