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

/// Texels of one colour under a weight of 1, which are exact.
template <class Sink>
struct WholeTexels {
    Sink& sink;
    Cell base;

    void tell(const Cell& cell, double area) const {
        sink.texel({base.column + cell.column, base.row + cell.row}, {area});
    }
    void part(const Cell& cell, const Polygon<double>& polygon) const { tell(cell, area_of(polygon)); }
    bool takes(const TexelLattice<double>&, std::int64_t, std::int64_t, std::int64_t) const { return true; }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        lattice.visit_run(row, first, last, [&](const Cell& cell, double area) { tell(cell, area); });
    }
};

/// Texels, or the patches between the centres of texels (k, l) and (k + 1, l + 1), by their moments.
template <int across, class Sink>
struct MeasuredCells {
    Sink& sink;
    Homography<double> map;
    Cell base;
    const PixelWeight& weight;
    bool are_texels;

    void tell(const Cell& cell, const BilinearMoments<across>& m) const {
        const Cell there{base.column + cell.column, base.row + cell.row};
        are_texels ? sink.texel(there, m.one) : sink.patch(there, m);
    }
    void part(const Cell& cell, const Polygon<double>& polygon) const {
        const Homography<double> within{from_line(map.u, cell.column, map.w),
                                        from_line(map.v, cell.row, map.w), map.w};
        tell(cell, bilinear_moments<across>(polygon, within, weight));
    }
    bool takes(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        return WholeCellMoments<across>(map, lattice, weight, row, first, last).hold();
    }
    void whole(const TexelLattice<double>& lattice, std::int64_t row, std::int64_t first,
               std::int64_t last) const {
        const WholeCellMoments<across> moments(map, lattice, weight, row, first, last);
        for (std::int64_t k = first; k < last; ++k) tell({k, row}, moments.of({k, row}));
    }
};

/// Tells the sink what each pixel's sum gets of each texel, or of each patch between four.
template <int across, class Sink>
void measure(const Polygon<double>& piece, const Homography<double>& texels, Reconstruction reconstruction,
             const PixelWeight& weight, Sink& sink) {
    const bool are_texels = is_of_nearest(reconstruction);
    const Affine<double> shift = (are_texels ? 0.0 : 0.5) * texels.w;
    const auto [map, base] = rebased<double>({texels.u - shift, texels.v - shift, texels.w}, piece[0]);
    if constexpr (across == 1)
        if (are_texels) {
            WholeTexels<Sink> cells{sink, base};
            return TexelWalk<double, WholeTexels<Sink>>(map, cells).rows(piece);
        }
    MeasuredCells<across, Sink> cells{sink, map, base, weight, are_texels};
    TexelWalk<double, MeasuredCells<across, Sink>>(map, cells).rows(piece);
}

/// The weights of the four texels around a patch: from the least row, and column, on.
template <int across>
std::array<EachPixel<across>, 4> corner_weights(const BilinearMoments<across>& m) {
    std::array<EachPixel<across>, 4> w;
    for (std::size_t i = 0; i < m.one.size(); ++i) {
        w[0][i] = m.one[i] - m.s[i] - m.t[i] + m.st[i];
        w[1][i] = m.s[i] - m.st[i];
        w[2][i] = m.t[i] - m.st[i];
        w[3][i] = m.st[i];
    }
    return w;
}

/// Sums texels times what they weigh.
template <int across>
class ColourSums {
  public:
    explicit ColourSums(const SurfaceColour& colour) : colour_(colour) {}

    void add(const glm::dvec3& texel, const EachPixel<across>& weights) {
        for (glm::length_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < weights.size(); ++i)
                sums_[std::size_t(c)][i] += weights[i] * texel[c];
    }
    void texel(const Cell& cell, const EachPixel<across>& weights) {
        add(colour_.texel(colour_.column(cell.column), row_of(cell.row)), weights);
    }
    void patch(const Cell& cell, const BilinearMoments<across>& moments) {
        const std::array<EachPixel<across>, 4> weights = corner_weights(moments);
        const int left = colour_.column(cell.column), right = colour_.column(cell.column + 1),
                  low = row_of(cell.row), high = colour_.row(cell.row + 1);
        add(colour_.texel(left, low), weights[0]);
        add(colour_.texel(right, low), weights[1]);
        add(colour_.texel(left, high), weights[2]);
        add(colour_.texel(right, high), weights[3]);
    }
    glm::dvec3 of(int pixel) const {
        const auto i = std::size_t(pixel);
        return colour_.factor * glm::dvec3(sums_[0][i], sums_[1][i], sums_[2][i]);
    }

  private:
    int row_of(std::int64_t row) {
        if (row != row_) row_ = row, row_of_image_ = colour_.row(row);
        return row_of_image_;
    }

    const SurfaceColour& colour_;
    std::int64_t row_ = std::numeric_limits<std::int64_t>::min();
    int row_of_image_ = 0;
    std::array<EachPixel<across>, 3> sums_{};
};

/// Tells what texels weigh for one pixel instead.
template <int across>
struct PixelWeights {
    std::size_t pixel;
    const CellVisit& visit;

    void texel(const Cell& cell, const EachPixel<across>& weights) const { visit(cell, weights[pixel]); }
    void patch(const Cell& cell, const BilinearMoments<across>& moments) const {
        const std::array<EachPixel<across>, 4> weights = corner_weights(moments);
        for (int i = 0; i < 4; ++i) texel({cell.column + i % 2, cell.row + i / 2}, weights[std::size_t(i)]);
    }
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
                measure<across>(part, texels, reconstruction, weight, colours);
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
            PixelWeights<across> weights{std::size_t(pixel), visit};
            measure<across>(part, texels, reconstruction, weight, weights);
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
