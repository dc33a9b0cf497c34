/// How much each place around a pixel's centre counts in the pixel's mean (docs/area-integral.md, "Weights").
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "filters/area/area_integral.h"
#include "filters/area/polygon.h"
#include "filters/area/triangle_rules.h"

namespace zproof::oracle::area {

/// A place drawn at random, and its weight over the density of draws there: the mean of draws' weights times
/// colours is the weighted mean.
struct Draw {
    glm::dvec2 offset_px{0};
    double weight = 1;
};

/// Offsets in px from the pixel's centre.
struct PixelWeight {
    double half_side = 0.5;                          ///< of the square beyond which nothing counts
    double (*at)(const Point<double>& p) = nullptr;  ///< may be negative; null: 1 all over the square
    std::vector<Polygon<double>> blocks{};           ///< all that counts, in parts that `rule` can take
    std::span<const Node> rule{};                    ///< for the triangles of pieces of a block
    double total = 1;                                ///< of all blocks by that rule: a mean's denominator
    double error = 0;                       ///< the most that a mean of texels from 0 to 1 can be off
    double cost = 1;                        ///< of a texel, about, beside that under a weight of 1
    Draw (*drawn)(const glm::dvec2& unit);  ///< by a place in the unit square
    double greatest_draw = 1;               ///< no draw's weight is greater in magnitude
};

const PixelWeight& weight_of(Reconstruction reconstruction);

}  // namespace zproof::oracle::area
