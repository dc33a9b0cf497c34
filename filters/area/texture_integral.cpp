#include "filters/area/texture_integral.h"

#include <cmath>

#include "filters/area/bilinear_moments.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/texel_walk.h"

namespace zproof::oracle::area {

namespace {

/// What a piece weighs, px^2.
double mass(const Polygon<double>& piece, const PixelWeight& weight) {
    if (weight.at == nullptr) return area_of(piece);
    const Affine<double> one{0, 0, 1};
    return weighted_moments(piece, {one, one, one}, weight).one;
}

/// Sums texels times what they weigh.
struct NearestSum {
    const SurfaceColour& colour;
    Cell base;
    const PixelWeight& weight;
    glm::dvec3 sum{0};

    void part(const Cell& cell, const Polygon<double>& polygon) {
        sum += mass(polygon, weight) *
               colour.texel(colour.column(base.column + cell.column), colour.row(base.row + cell.row));
    }
    bool takes(const TexelLattice<double>&, std::int64_t, std::int64_t, std::int64_t) const {
        return weight.at == nullptr;
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first, std::int64_t last) {
        const int in_row = colour.row(base.row + row);
        lattice.visit_run(row, first, last, [&](const Cell& cell, double area) {
            sum += area * colour.texel(colour.column(base.column + cell.column), in_row);
        });
    }
};

/// Tells what they weigh instead.
struct NearestWeights {
    Cell base;
    const PixelWeight& weight;
    const CellVisit& visit;

    void tell(const Cell& cell, double mass) const {
        visit({base.column + cell.column, base.row + cell.row}, mass);
    }
    void part(const Cell& cell, const Polygon<double>& polygon) const { tell(cell, mass(polygon, weight)); }
    bool takes(const TexelLattice<double>&, std::int64_t, std::int64_t, std::int64_t) const {
        return weight.at == nullptr;
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        lattice.visit_run(row, first, last, [&](const Cell& cell, double area) { tell(cell, area); });
    }
};

/// The weights of the four texels around a cell.
struct PatchWeights {
    double low_left, low_right, high_left, high_right;

    explicit PatchWeights(const BilinearMoments& m)
        : low_left(m.one - m.s - m.t + m.st),
          low_right(m.s - m.st),
          high_left(m.t - m.st),
          high_right(m.st) {}
};

/// Sums texels times weights.
struct ColourSum {
    const SurfaceColour& colour;
    glm::dvec3 sum{0};

    void add(const Cell& cell, const PatchWeights& w) {
        const int left = colour.column(cell.column), low = colour.row(cell.row),
                  right = colour.column(cell.column + 1), high = colour.row(cell.row + 1);
        sum += w.low_left * colour.texel(left, low) + w.low_right * colour.texel(right, low) +
               w.high_left * colour.texel(left, high) + w.high_right * colour.texel(right, high);
    }
};

/// Tells the weights instead.
struct PatchVisit {
    const CellVisit& visit;

    void add(const Cell& cell, const PatchWeights& w) const {
        visit(cell, w.low_left);
        visit({cell.column + 1, cell.row}, w.low_right);
        visit({cell.column, cell.row + 1}, w.high_left);
        visit({cell.column + 1, cell.row + 1}, w.high_right);
    }
};

/// Walks bilinear patches; cell (k, l) lies between the centres of texels (k, l) and (k + 1, l + 1).
template <class Sink>
struct BilinearPatches {
    Sink& sink;
    Homography<double> map;
    Cell base;
    const PixelWeight& weight;

    void add(const Cell& cell, const BilinearMoments& m) {
        sink.add({base.column + cell.column, base.row + cell.row}, PatchWeights(m));
    }
    void part(const Cell& cell, const Polygon<double>& polygon) {
        const Homography<double> within{from_line(map.u, cell.column, map.w),
                                        from_line(map.v, cell.row, map.w), map.w};
        add(cell, weight.at == nullptr ? bilinear_moments(polygon, within)
                                       : weighted_moments(polygon, within, weight));
    }
    bool takes(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        return weight.at == nullptr && WholeCellMoments(lattice).holds_for(row, first, last);
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first, std::int64_t last) {
        const WholeCellMoments moments(lattice);
        for (std::int64_t k = first; k < last; ++k) add({k, row}, moments.of({k, row}));
    }
};

template <class Sink>
void walk_patches(Sink& sink, const Polygon<double>& piece, const Homography<double>& texels,
                  const PixelWeight& weight) {
    const Affine<double> half = 0.5 * texels.w;
    const auto [map, base] = rebased<double>({texels.u - half, texels.v - half, texels.w}, piece[0]);
    BilinearPatches<Sink> patches{sink, map, base, weight};
    TexelWalk<double, BilinearPatches<Sink>>(map, patches).rows(piece);
}

glm::dvec3 sum_of_patches(const SurfaceColour& colour, const Polygon<double>& piece,
                          const Homography<double>& texels, const PixelWeight& weight) {
    ColourSum sum{colour};
    walk_patches(sum, piece, texels, weight);
    return sum.sum;
}

glm::dvec3 sum_of_texels(const SurfaceColour& colour, const Polygon<double>& piece,
                         const Homography<double>& texels, const PixelWeight& weight) {
    const auto [map, base] = rebased(texels, piece[0]);
    NearestSum sum{colour, base, weight};
    TexelWalk<double, NearestSum>(map, sum).rows(piece);
    return sum.sum;
}

/// The intersection of two convex polygons; `by` has its corners in clockwise order (y down).
Polygon<double> common(Polygon<double> polygon, const Polygon<double>& by) {
    for (std::size_t i = 0; i < by.size() && polygon.size() > 2; ++i) {
        const Point<double>&p = by[i], &q = by[(i + 1) % by.size()];
        const double a = p.y - q.y, b = q.x - p.x;
        polygon = cut(polygon, Affine<double>{a, b, -(a * p.x + b * p.y)}).inside;
    }
    return polygon;
}

/// The parts of a piece in the weight's blocks.
template <class Visit>
void for_each_part(const Polygon<double>& piece, const PixelWeight& weight, const Visit& visit) {
    if (weight.blocks.empty()) return visit(piece);
    for (const Polygon<double>& block : weight.blocks)
        if (const Polygon<double> part = common(piece, block); part.size() > 2) visit(part);
}

}  // namespace

glm::dvec3 colour_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                           const Homography<double>& texels, Reconstruction reconstruction) {
    const PixelWeight& weight = weight_of(reconstruction);
    glm::dvec3 sum{0};
    for_each_part(piece, weight, [&](const Polygon<double>& part) {
        if (colour.image == nullptr)
            sum += mass(part, weight);
        else
            sum += is_of_nearest(reconstruction) ? sum_of_texels(colour, part, texels, weight)
                                                 : sum_of_patches(colour, part, texels, weight);
    });
    return sum * colour.factor;
}

void visit_weights(const Polygon<double>& piece, const Homography<double>& texels,
                   Reconstruction reconstruction, const CellVisit& visit) {
    const PixelWeight& weight = weight_of(reconstruction);
    for_each_part(piece, weight, [&](const Polygon<double>& part) {
        if (is_of_nearest(reconstruction)) {
            const auto [map, base] = rebased(texels, part[0]);
            NearestWeights weights{base, weight, visit};
            TexelWalk<double, NearestWeights>(map, weights).rows(part);
        } else {
            PatchVisit sink{visit};
            walk_patches(sink, part, texels, weight);
        }
    });
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
