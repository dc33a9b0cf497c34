/// How much each place around a pixel's centre counts in the pixel's mean (docs/area-integral.md, "Weights").
///
/// The square that counts for a pixel is made of unit squares, `across` by `across`. So each unit square
/// counts for that many pixels, and is integrated once for all of them.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <type_traits>
#include <vector>

#include "filters/area/area_integral.h"
#include "filters/area/polygon.h"
#include "filters/area/triangle_rules.h"

namespace zproof::oracle::area {

/// A place drawn at random, and its weight over the density of draws there: the mean of draws' weights times
/// colours is the weighted mean.
struct Draw {
    glm::dvec2 offset_px{0};  ///< from the pixel's centre
    double weight = 1;
};

/// A rule for triangles of pieces no wider and no higher than this.
struct SizedRule {
    double side_px;
    std::span<const Node> rule;
};

/// A part of a unit square on which a weight is smooth; offsets from the square's middle.
struct WeightBlock {
    Polygon<double> polygon{};
    std::uint32_t pixels = 1;  ///< those that it counts for: bit (row * across + column)

    bool counts_for(int pixel) const { return (pixels >> pixel & 1) != 0; }
};

inline constexpr std::size_t most_across = 4, most_nodes = 25;  ///< of a rule
using AxisWeights = std::array<double, most_across>;

struct PixelWeight {
    double half_side = 0.5;  ///< of the square beyond which nothing counts
    int across = 1;          ///< twice that
    /// At offsets from the middle of a unit square, -0.5 to 0.5 along one axis, the factors of the weights
    /// for `across` pixels, from the first to the last, whose centres are 1 px apart; null: 1. At most
    /// most_nodes offsets.
    void (*along)(std::span<const double> offsets, AxisWeights* factors) = nullptr;
    double at_rim = 0;  ///< what is taken from the product of both axes' factors
    std::vector<WeightBlock> blocks{{square(0.5)}};
    std::vector<SizedRule> rules{};         ///< from the least side on; the last is for all pieces
    double total = 1;                       ///< of all squares by these rules: a mean's denominator
    double error = 0;                       ///< the most that a mean of texels from 0 to 1 can be off
    double cost = 1;                        ///< of a texel, about, beside that under a weight of 1
    Draw (*drawn)(const glm::dvec2& unit);  ///< by a place in the unit square
    double greatest_draw = 1;               ///< no draw's weight is greater in magnitude
};

/// f(std::integral_constant<int, across>), for code that is made for each number.
template <class F>
auto for_across(int across, const F& f) {
    switch (across) {
        case 1:
            return f(std::integral_constant<int, 1>{});
        case 2:
            return f(std::integral_constant<int, 2>{});
        case 3:
            return f(std::integral_constant<int, 3>{});
        default:
            return f(std::integral_constant<int, 4>{});
    }
}

const PixelWeight& weight_of(Reconstruction reconstruction);

}  // namespace zproof::oracle::area
