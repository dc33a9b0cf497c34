#include "oracle/area/texture_integral.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/area/bilinear_moments.h"
#include "oracle/area/texel_walk.h"

namespace zproof::oracle::area {

namespace {

enum class Weight { uniform, gaussian };

/// The weight of the disk alone, as a surface without a texture.
double weight_within(const Polygon<double>& piece) {
    const Affine<double> one{0, 0, 1};
    return gaussian_moments(piece, {one, one, one}).one;
}

/// Sums texels times areas, or times the weight there.
struct NearestSum {
    const SurfaceColour& colour;
    Cell base;
    Weight weight = Weight::uniform;
    glm::dvec3 sum{0};

    void part(const Cell& cell, const Polygon<double>& polygon) {
        sum += (weight == Weight::uniform ? area_of(polygon) : weight_within(polygon)) *
               colour.texel(colour.column(base.column + cell.column), colour.row(base.row + cell.row));
    }
    bool takes(const TexelLattice<double>&, std::int64_t, std::int64_t, std::int64_t) const {
        return weight == Weight::uniform;
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first, std::int64_t last) {
        const int in_row = colour.row(base.row + row);
        lattice.visit_run(row, first, last, [&](const Cell& cell, double area) {
            sum += area * colour.texel(colour.column(base.column + cell.column), in_row);
        });
    }
};

/// Tells areas instead.
struct NearestWeights {
    Cell base;
    const CellVisit& visit;
    Weight weight = Weight::uniform;

    void tell(const Cell& cell, double area) const {
        visit({base.column + cell.column, base.row + cell.row}, area);
    }
    void part(const Cell& cell, const Polygon<double>& polygon) const {
        tell(cell, weight == Weight::uniform ? area_of(polygon) : weight_within(polygon));
    }
    bool takes(const TexelLattice<double>&, std::int64_t, std::int64_t, std::int64_t) const {
        return weight == Weight::uniform;
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
    Weight weight;

    void add(const Cell& cell, const BilinearMoments& m) {
        sink.add({base.column + cell.column, base.row + cell.row}, PatchWeights(m));
    }
    void part(const Cell& cell, const Polygon<double>& polygon) {
        const Homography<double> within{from_line(map.u, cell.column, map.w),
                                        from_line(map.v, cell.row, map.w), map.w};
        add(cell, weight == Weight::uniform ? bilinear_moments(polygon, within)
                                            : gaussian_moments(polygon, within));
    }
    bool takes(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        return weight == Weight::uniform && WholeCellMoments(lattice).holds_for(row, first, last);
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first, std::int64_t last) {
        const WholeCellMoments moments(lattice);
        for (std::int64_t k = first; k < last; ++k) add({k, row}, moments.of({k, row}));
    }
};

template <class Sink>
void walk_patches(Sink& sink, const Polygon<double>& piece, const Homography<double>& texels, Weight weight) {
    const Affine<double> half = 0.5 * texels.w;
    const auto [map, base] = rebased<double>({texels.u - half, texels.v - half, texels.w}, piece[0]);
    BilinearPatches<Sink> patches{sink, map, base, weight};
    TexelWalk<double, BilinearPatches<Sink>>(map, patches).rows(piece);
}

glm::dvec3 patches(const SurfaceColour& colour, const Polygon<double>& piece,
                   const Homography<double>& texels, Weight weight) {
    ColourSum sum{colour};
    walk_patches(sum, piece, texels, weight);
    return sum.sum * colour.factor;
}

/// The disk of radius 1 px in squares of 1/4 px; its rim is a regular polygon whose corners lie on it.
std::vector<Polygon<double>> disk_blocks() {
    constexpr int rim_corners = 64, blocks_across = 8;
    constexpr double side = 2.0 / blocks_across;
    std::vector<Polygon<double>> blocks;
    for (int row = 0; row < blocks_across; ++row)
        for (int column = 0; column < blocks_across; ++column) {
            const double left = column * side - 1, top = row * side - 1, right = left + side,
                         bottom = top + side;
            Polygon<double> block{{left, top}, {right, top}, {right, bottom}, {left, bottom}};
            for (int i = 0; i < rim_corners; ++i) {
                const double angle = (2 * i + 1) * std::numbers::pi / rim_corners;
                block = cut(block, Affine<double>{-std::cos(angle), -std::sin(angle),
                                                  std::cos(std::numbers::pi / rim_corners)})
                            .inside;
            }
            if (block.size() > 2) blocks.push_back(block);
        }
    return blocks;
}

const std::vector<Polygon<double>>& blocks() {
    static const std::vector<Polygon<double>> made = disk_blocks();
    return made;
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

}  // namespace

glm::dvec3 bilinear_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                             const Homography<double>& texels) {
    if (colour.image == nullptr) return area_of(piece) * colour.factor;
    return patches(colour, piece, texels, Weight::uniform);
}

namespace {

/// The sum over the disk's blocks of what a part of the piece gives.
template <class OfPart>
glm::dvec3 over_the_disk(const SurfaceColour& colour, const Polygon<double>& piece, const OfPart& of_part) {
    glm::dvec3 sum{0};
    for (const Polygon<double>& block : blocks()) {
        const Polygon<double> part = common(piece, block);
        if (part.size() < 3) continue;
        sum += colour.image == nullptr ? weight_within(part) * colour.factor : of_part(part);
    }
    return sum;
}

/// Sums over the texels of a piece, under a weight.
glm::dvec3 texels_of(const SurfaceColour& colour, const Polygon<double>& piece,
                     const Homography<double>& texels, Weight weight) {
    const auto [map, base] = rebased(texels, piece[0]);
    NearestSum sum{colour, base, weight};
    TexelWalk<double, NearestSum>(map, sum).rows(piece);
    return sum.sum * colour.factor;
}

}  // namespace

glm::dvec3 gaussian_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                             const Homography<double>& texels) {
    return over_the_disk(colour, piece, [&](const Polygon<double>& part) {
        return patches(colour, part, texels, Weight::gaussian);
    });
}

glm::dvec3 gaussian_integral_of_nearest(const SurfaceColour& colour, const Polygon<double>& piece,
                                        const Homography<double>& texels) {
    return over_the_disk(colour, piece, [&](const Polygon<double>& part) {
        return texels_of(colour, part, texels, Weight::gaussian);
    });
}

double gaussian_total() {
    static const double total = [] {
        double sum = 0;
        for (const Polygon<double>& block : blocks()) sum += weight_within(block);
        return sum;
    }();
    return total;
}

glm::dvec3 nearest_integral(const SurfaceColour& colour, const Polygon<double>& piece,
                            const Homography<double>& texels) {
    if (colour.image == nullptr) return area_of(piece) * colour.factor;
    return texels_of(colour, piece, texels, Weight::uniform);
}

void visit_nearest_weights(const Polygon<double>& piece, const Homography<double>& texels,
                           const CellVisit& visit) {
    const auto [map, base] = rebased(texels, piece[0]);
    NearestWeights weights{base, visit};
    TexelWalk<double, NearestWeights>(map, weights).rows(piece);
}

void visit_bilinear_weights(const Polygon<double>& piece, const Homography<double>& texels,
                            const CellVisit& visit) {
    PatchVisit sink{visit};
    walk_patches(sink, piece, texels, Weight::uniform);
}

void visit_gaussian_weights(const Polygon<double>& piece, const Homography<double>& texels,
                            const CellVisit& visit) {
    PatchVisit sink{visit};
    for (const Polygon<double>& block : blocks()) {
        const Polygon<double> part = common(piece, block);
        if (part.size() > 2) walk_patches(sink, part, texels, Weight::gaussian);
    }
}

void visit_gaussian_weights_of_nearest(const Polygon<double>& piece, const Homography<double>& texels,
                                       const CellVisit& visit) {
    for (const Polygon<double>& block : blocks()) {
        const Polygon<double> part = common(piece, block);
        if (part.size() < 3) continue;
        const auto [map, base] = rebased(texels, part[0]);
        NearestWeights weights{base, visit, Weight::gaussian};
        TexelWalk<double, NearestWeights>(map, weights).rows(part);
    }
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
