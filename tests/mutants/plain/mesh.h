/// What the plain renderer takes and gives: plain arrays, as docs/renderer-contract.md describes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/mutants/plain/vector.h"

namespace plain {

struct Primitive {
    std::vector<Vec3<float>> positions;  ///< world space
    std::vector<std::uint32_t> indices;  ///< three are one triangle
};

/// A triangle's id is its index through all primitives in order.
using Mesh = std::vector<Primitive>;

enum class Projection { perspective, parallel };

struct Window {
    double left, right, bottom, top;
};

struct Camera {
    Projection projection = Projection::perspective;
    Vec3<float> eye{};
    Vec3<double> right{}, up{}, back{};
    Window window{};
    double near = 0, far = 0;  ///< camera depths; far may be infinite
    double shear_x = 0, shear_y = 0;
    int width = 0, height = 0;

    /// Of the image plane, at the centre of a column or row of pixels.
    double u(int x) const { return window.left + (window.right - window.left) * (x + 0.5) / width; }
    double v(int y) const { return window.top - (window.top - window.bottom) * (y + 0.5) / height; }
};

inline constexpr std::uint32_t background = 0xFFFF'FFFF;

/// Row 0 at the top.
struct Picture {
    int width, height;
    std::vector<std::uint32_t> ids;
    std::vector<float> depths;

    Picture(int w, int h)
        : width(w),
          height(h),
          ids(std::size_t(w) * std::size_t(h), background),
          depths(ids.size(), std::numeric_limits<float>::infinity()) {}

    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

}  // namespace plain
