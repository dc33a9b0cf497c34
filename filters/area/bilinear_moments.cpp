#include "filters/area/bilinear_moments.h"

#include <algorithm>
#include <cmath>

namespace zproof::oracle::area {

namespace {

/// r = (W_max - W_min) / (W_max + W_min) over a piece on which a rule is used.
constexpr double most_variation = 0x1p-8;

/// Sums nodes of rules under the weights of all pixels.
template <int across>
class WeightedNodes {
  public:
    explicit WeightedNodes(const PixelWeight& weight) : weight_(weight) {}

    void add(const Point<double>& p, double share, double s, double t) {
        x_[count_] = p.x, y_[count_] = p.y;
        bears_[count_++] = {share, share * s, share * t, share * (s * t)};
    }

    /// Adds the nodes' sums times the area, and forgets the nodes.
    void add_to(BilinearMoments<across>& moments, double area) {
        std::array<AxisWeights, most_nodes> x, y;
        weight_.along({x_.data(), count_}, x.data());
        weight_.along({y_.data(), count_}, y.data());
        for (std::size_t row = 0; row < n; ++row) {
            std::array<std::array<double, n>, 4> sums{};
            for (std::size_t i = 0; i < count_; ++i)
                for (std::size_t m = 0; m < 4; ++m)
                    for (std::size_t k = 0; k < n; ++k)
                        sums[m][k] += (x[i][k] * y[i][row] - weight_.at_rim) * bears_[i][m];
            for (std::size_t k = 0; k < n; ++k) {
                moments.one[row * n + k] += area * sums[0][k];
                moments.s[row * n + k] += area * sums[1][k];
                moments.t[row * n + k] += area * sums[2][k];
                moments.st[row * n + k] += area * sums[3][k];
            }
        }
        count_ = 0;
    }

  private:
    static constexpr auto n = std::size_t(across);

    const PixelWeight& weight_;
    std::array<double, most_nodes> x_, y_;
    std::array<std::array<double, 4>, most_nodes> bears_;  ///< a share times 1, s, t and s t
    std::size_t count_ = 0;
};

/// The same under a weight of 1.
template <>
class WeightedNodes<1> {
  public:
    explicit WeightedNodes(const PixelWeight&) {}

    void add(const Point<double>&, double share, double s, double t) {
        one_ += share;
        s_ += share * s;
        t_ += share * t;
        st_ += share * (s * t);
    }
    void add_to(BilinearMoments<1>& moments, double area) {
        moments.one[0] += area * one_;
        moments.s[0] += area * s_;
        moments.t[0] += area * t_;
        moments.st[0] += area * st_;
        one_ = s_ = t_ = st_ = 0;
    }

  private:
    double one_ = 0, s_ = 0, t_ = 0, st_ = 0;
};

/// The functionals at a corner; affine, so that barycentrics interpolate them.
struct Corner {
    Point<double> p;
    double s, t, w;
};

/// The greater of a polygon's width and height.
double side_of(const Polygon<double>& polygon) {
    Point<double> low = polygon[0], high = low;
    for (const Point<double>& p : polygon) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return std::max(high.x - low.x, high.y - low.y);
}

std::span<const Node> rule_for(const Polygon<double>& piece, const PixelWeight& weight) {
    if (weight.rules.size() == 1) return weight.rules[0].rule;
    const double side = side_of(piece);
    return std::ranges::find_if(weight.rules, [&](const SizedRule& r) { return side <= r.side_px; })->rule;
}

/// Sums a piece of the image under a weight of places.
template <int across>
class Sum {
  public:
    Sum(const Homography<double>& cell, const PixelWeight& weight)
        : cell_(cell), weight_(weight), nodes_(weight) {}

    /// Halves the range of W until it is narrow enough.
    void add_piece(const Polygon<double>& piece) {
        if (piece.size() < 3) return;
        double low = cell_.w.at(piece[0].x, piece[0].y), high = low;
        for (const Point<double>& p : piece) {
            const double w = cell_.w.at(p.x, p.y);
            low = std::min(low, w), high = std::max(high, w);
        }
        if (high - low <= most_variation * (high + low) || piece.size() > most_corners - 8)
            return add_fan(piece);
        const Halves<double> halves = cut(piece, cell_.w - Affine<double>{0, 0, (low + high) / 2});
        add_piece(halves.inside);
        add_piece(halves.outside);
    }

    const BilinearMoments<across>& moments() const { return sum_; }

  private:
    Corner corner(const Point<double>& p) const {
        return {p, cell_.u.at(p.x, p.y), cell_.v.at(p.x, p.y), cell_.w.at(p.x, p.y)};
    }

    void add_fan(const Polygon<double>& piece) {
        const std::span<const Node> rule = rule_for(piece, weight_);
        const Corner hub = corner(piece[0]);
        Corner from = corner(piece[1]);
        for (std::size_t i = 2; i < piece.size(); ++i) {
            const Corner to = corner(piece[i]);
            add_triangle({hub, from, to}, rule);
            from = to;
        }
    }

    void add_triangle(const std::array<Corner, 3>& c, std::span<const Node> rule) {
        for (const Node& n : rule) {
            const auto blend = [&](double f, double g, double h) { return n.a * f + n.b * g + n.c * h; };
            const Point<double> p{blend(c[0].p.x, c[1].p.x, c[2].p.x), blend(c[0].p.y, c[1].p.y, c[2].p.y)};
            const double per_w = 1 / blend(c[0].w, c[1].w, c[2].w);
            nodes_.add(p, n.weight, blend(c[0].s, c[1].s, c[2].s) * per_w,
                       blend(c[0].t, c[1].t, c[2].t) * per_w);
        }
        nodes_.add_to(sum_, area_of(Polygon<double>{c[0].p, c[1].p, c[2].p}));
    }

    const Homography<double>& cell_;
    const PixelWeight& weight_;
    WeightedNodes<across> nodes_;
    BilinearMoments<across> sum_;
};

/// With x = p s' + q t' on the cell [-1/2, 1/2]^2 round its centre, 1 / Z^3 = (1 - 3 x + 6 x^2 - 10 x^3 + 15
/// x^4 ...) / Z_c^3, and the means of s'^2, s'^4 are 1/12, 1/80.
BilinearMoments<1> series(const TexelLattice<double>& lattice, const Cell& cell) {
    const Affine<double> z = lattice.z();
    const double per_z = 1 / z.at(double(cell.column) + 0.5, double(cell.row) + 0.5);
    const double p = z.a * per_z, q = z.b * per_z, pp = p * p, qq = q * q;
    const double scale = lattice.per_det() * (per_z * per_z * per_z);
    const double one = scale * (1 + (pp + qq) / 2 + 3.0 / 16 * (pp * pp + qq * qq) + 5.0 / 8 * (pp * qq));
    const double s = -scale * p * (1.0 / 4 + pp / 8 + 5.0 / 24 * qq);
    const double t = -scale * q * (1.0 / 4 + qq / 8 + 5.0 / 24 * pp);
    const double st = scale * (p * q) * (1.0 / 12 + (pp + qq) / 16);
    return {{one}, {s + one / 2}, {t + one / 2}, {st + (s + t) / 2 + one / 4}};
}

/// The greatest magnitude of f - k w from k = first to last.
double greatest(double f, double w, std::int64_t first, std::int64_t last) {
    return std::max(std::abs(f - double(first) * w), std::abs(f - double(last) * w));
}

}  // namespace

template <int across>
BilinearMoments<across> bilinear_moments(const Polygon<double>& piece, const Homography<double>& cell,
                                         const PixelWeight& weight) {
    Sum<across> sum(cell, weight);
    sum.add_piece(piece);
    return sum.moments();
}

template <int across>
WholeCellMoments<across>::WholeCellMoments(const Homography<double>& map, const TexelLattice<double>& lattice,
                                           const PixelWeight& weight, std::int64_t row, std::int64_t first,
                                           std::int64_t last)
    : map_(map), lattice_(lattice), weight_(weight) {
    const double least_z = std::min(
        {lattice.z(first, row), lattice.z(first, row + 1), lattice.z(last, row), lattice.z(last, row + 1)});
    const double slope = std::abs(lattice.z().a) + std::abs(lattice.z().b);
    hold_ = slope <= most_variation * least_z;
    if (across == 1 || !hold_) return;
    const double step = step_px(row, first, last, least_z);
    hold_ = step <= 0x1p-3;
    rule_ = step <= 0x1p-6 ? gauss_of_two() : gauss_of_three();
}

/// No more than |dx| + |dy| of a step along u or v. With Z = 1 / W, the derivatives are those of V - v W and
/// of U - u W in the image, over |det M| Z^2.
template <int across>
double WholeCellMoments<across>::step_px(std::int64_t row, std::int64_t first, std::int64_t last,
                                         double least_z) const {
    const auto& [u, v, w] = map_;
    const double along_u = greatest(v.a, w.a, row, row + 1) + greatest(v.b, w.b, row, row + 1);
    const double along_v = greatest(u.a, w.a, first, last) + greatest(u.b, w.b, first, last);
    return std::max(along_u, along_v) * lattice_.per_det() / (least_z * least_z);
}

template <int across>
BilinearMoments<across> WholeCellMoments<across>::of(const Cell& cell) const {
    if constexpr (across == 1) {
        return series(lattice_, cell);
    } else {
        WeightedNodes<across> nodes(weight_);
        for (const GaussNode& t : rule_)
            for (const GaussNode& s : rule_) {
                const double u = double(cell.column) + s.place, v = double(cell.row) + t.place;
                const double per_z = 1 / lattice_.z().at(u, v);
                nodes.add(lattice_.place(u, v), s.weight * t.weight * (per_z * per_z * per_z), s.place,
                          t.place);
            }
        BilinearMoments<across> moments;
        nodes.add_to(moments, lattice_.per_det());
        return moments;
    }
}

template BilinearMoments<1> bilinear_moments<1>(const Polygon<double>&, const Homography<double>&,
                                                const PixelWeight&);
template BilinearMoments<2> bilinear_moments<2>(const Polygon<double>&, const Homography<double>&,
                                                const PixelWeight&);
template BilinearMoments<3> bilinear_moments<3>(const Polygon<double>&, const Homography<double>&,
                                                const PixelWeight&);
template BilinearMoments<4> bilinear_moments<4>(const Polygon<double>&, const Homography<double>&,
                                                const PixelWeight&);
template class WholeCellMoments<1>;
template class WholeCellMoments<2>;
template class WholeCellMoments<3>;
template class WholeCellMoments<4>;

}  // namespace zproof::oracle::area
