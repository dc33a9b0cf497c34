#include "oracle/area/texture_integral.h"

#include <cmath>

#include "oracle/area/texel_walk.h"

namespace zproof::oracle::area {

namespace {

/// Sums texels times areas.
struct NearestSum {
    const SurfaceColour& colour;
    Cell base;
    glm::dvec3 sum{0};

    void part(const Cell& cell, const Polygon<double>& polygon) {
        sum += area_of(polygon) * colour.texel(base.column + cell.column, base.row + cell.row);
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first, std::int64_t last) {
        lattice.visit_run(row, first, last, [&](const Cell& cell, double area) {
            sum += area * colour.texel(base.column + cell.column, base.row + cell.row);
        });
    }
};

}  // namespace

glm::dvec3 nearest_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                            const Homography<double>& texels) {
    if (colour.image == nullptr) return area_of(piece) * colour.factor;
    const auto [map, base] = rebased(texels, piece[0]);
    NearestSum sum{colour, base};
    TexelWalk<double, NearestSum>(map, sum).rows(piece);
    return sum.sum * colour.factor;
}

double texel_cost(const Polygon<double>& piece, const Homography<double>& texels) {
    const auto place = [&](std::size_t i) {
        const auto [u, v] = texels.at(piece[i].x, piece[i].y);
        return glm::dvec2{u, v};
    };
    double twice_area = 0, outline = 0;
    const glm::dvec2 origin = place(0);
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const glm::dvec2 p = place(i) - origin, q = place((i + 1) % piece.size()) - origin;
        twice_area += p.x * q.y - p.y * q.x;
        outline += std::abs(q.x - p.x) + std::abs(q.y - p.y);
    }
    return std::abs(twice_area) / 2 + 8 * outline;
}

}  // namespace zproof::oracle::area
