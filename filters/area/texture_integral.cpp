#include "filters/area/texture_integral.h"

#include <array>
#include <cmath>
#include <limits>

#include "filters/area/bilinear_moments.h"
#include "filters/area/pixel_weight.h"
#include "filters/area/texel_walk.h"

namespace zproof::oracle::area {

namespace {

/// What a piece weighs for each pixel, px^2.
template <int across>
EachPixel<across> mass(const Polygon<double>& piece, const PixelWeight& weight) {
    if constexpr (across == 1) {
        return {area_of(piece)};
    } else {
        const Affine<double> one{0, 0, 1};
        return bilinear_moments<across>(piece, {one, one, one}, weight).one;
    }
}

/// Walks texels: visit(cell, what each pixel's sum gets of it).
template <int across, class Visit>
struct NearestTexels {
    const Visit& visit;
    Homography<double> map;
    Cell base;
    const PixelWeight& weight;

    void tell(const Cell& cell, const EachPixel<across>& masses) const {
        visit(Cell{base.column + cell.column, base.row + cell.row}, masses);
    }
    void part(const Cell& cell, const Polygon<double>& polygon) const {
        tell(cell, mass<across>(polygon, weight));
    }
    bool takes(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        return across == 1 || WholeCellMoments<across>(map, lattice, weight, row, first, last).hold();
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        if constexpr (across == 1) {
            lattice.visit_run(row, first, last, [&](const Cell& cell, double area) { tell(cell, {area}); });
        } else {
            const WholeCellMoments<across> moments(map, lattice, weight, row, first, last);
            for (std::int64_t k = first; k < last; ++k) tell({k, row}, moments.of({k, row}).one);
        }
    }
};

/// Walks bilinear patches; cell (k, l) lies between the centres of texels (k, l) and (k + 1, l + 1).
template <int across, class Visit>
struct BilinearPatches {
    const Visit& visit;
    Homography<double> map;
    Cell base;
    const PixelWeight& weight;

    void add(const Cell& cell, const BilinearMoments<across>& m) const {
        EachPixel<across> low_left, low_right, high_left;
        for (std::size_t i = 0; i < low_left.size(); ++i) {
            low_left[i] = m.one[i] - m.s[i] - m.t[i] + m.st[i];
            low_right[i] = m.s[i] - m.st[i];
            high_left[i] = m.t[i] - m.st[i];
        }
        const std::int64_t column = base.column + cell.column, row = base.row + cell.row;
        visit(Cell{column, row}, low_left);
        visit(Cell{column + 1, row}, low_right);
        visit(Cell{column, row + 1}, high_left);
        visit(Cell{column + 1, row + 1}, m.st);
    }
    void part(const Cell& cell, const Polygon<double>& polygon) const {
        const Homography<double> within{from_line(map.u, cell.column, map.w),
                                        from_line(map.v, cell.row, map.w), map.w};
        add(cell, bilinear_moments<across>(polygon, within, weight));
    }
    bool takes(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        return WholeCellMoments<across>(map, lattice, weight, row, first, last).hold();
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        const WholeCellMoments<across> moments(map, lattice, weight, row, first, last);
        for (std::int64_t k = first; k < last; ++k) add({k, row}, moments.of({k, row}));
    }
};

template <template <int, class> class Texels, int across, class Visit>
void walk(const Polygon<double>& piece, const Homography<double>& texels, const PixelWeight& weight,
          const Visit& visit) {
    const auto [map, base] = rebased(texels, piece[0]);
    Texels<across, Visit> cells{visit, map, base, weight};
    TexelWalk<double, Texels<across, Visit>>(map, cells).rows(piece);
}

template <int across, class Visit>
void visit_texels(const Polygon<double>& piece, const Homography<double>& texels,
                  Reconstruction reconstruction, const PixelWeight& weight, const Visit& visit) {
    if (is_of_nearest(reconstruction)) return walk<NearestTexels, across>(piece, texels, weight, visit);
    const Affine<double> half = 0.5 * texels.w;
    walk<BilinearPatches, across>(piece, {texels.u - half, texels.v - half, texels.w}, weight, visit);
}

/// Texels times what they weigh.
template <int across>
class ColourSums {
  public:
    explicit ColourSums(const SurfaceColour& colour) : colour_(colour) {}

    void add(const Cell& cell, const EachPixel<across>& weights) {
        if (cell.row != row_) row_ = cell.row, row_of_image_ = colour_.row(cell.row);
        add(colour_.texel(colour_.column(cell.column), row_of_image_), weights);
    }
    void add(const glm::dvec3& texel, const EachPixel<across>& weights) {
        for (glm::length_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < weights.size(); ++i)
                sums_[std::size_t(c)][i] += weights[i] * texel[c];
    }
    glm::dvec3 of(int pixel) const {
        const auto i = std::size_t(pixel);
        return colour_.factor * glm::dvec3(sums_[0][i], sums_[1][i], sums_[2][i]);
    }

  private:
    const SurfaceColour& colour_;
    std::int64_t row_ = std::numeric_limits<std::int64_t>::min();
    int row_of_image_ = 0;
    std::array<EachPixel<across>, 3> sums_{};
};

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
    if (weight.blocks.size() == 1) return visit(piece, weight.blocks[0]);
    for (const WeightBlock& block : weight.blocks)
        if (const Polygon<double> part = common(piece, block.polygon); part.size() > 2) visit(part, block);
}

}  // namespace

void add_colour(const SurfaceColour& colour, const Polygon<double>& piece, const Homography<double>& texels,
                Reconstruction reconstruction, std::span<glm::dvec3> sums) {
    const PixelWeight& weight = weight_of(reconstruction);
    for_across(weight.across, [&]<int across>(std::integral_constant<int, across>) {
        for_each_part(piece, weight, [&](const Polygon<double>& part, const WeightBlock& block) {
            ColourSums<across> colours(colour);
            if (colour.image == nullptr)
                colours.add(glm::dvec3(1), mass<across>(part, weight));
            else
                visit_texels<across>(
                    part, texels, reconstruction, weight,
                    [&](const Cell& cell, const EachPixel<across>& masses) { colours.add(cell, masses); });
            for (int pixel = 0; pixel < across * across; ++pixel)
                if (block.counts_for(pixel)) sums[std::size_t(pixel)] += colours.of(pixel);
        });
    });
}

void visit_weights(const Polygon<double>& piece, const Homography<double>& texels,
                   Reconstruction reconstruction, int pixel, const CellVisit& visit) {
    const PixelWeight& weight = weight_of(reconstruction);
    for_across(weight.across, [&]<int across>(std::integral_constant<int, across>) {
        for_each_part(piece, weight, [&](const Polygon<double>& part, const WeightBlock& block) {
            if (!block.counts_for(pixel)) return;
            visit_texels<across>(part, texels, reconstruction, weight,
                                 [&](const Cell& cell, const EachPixel<across>& masses) {
                                     visit(cell, masses[std::size_t(pixel)]);
                                 });
        });
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
