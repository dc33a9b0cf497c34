#include "filters/area/bilinear_moments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "filters/area/triangle_rules.h"

namespace zproof::oracle::area {

namespace {

/// r = (W_max - W_min) / (W_max + W_min) over a piece on which the rule is used.
constexpr double most_variation = 0x1p-8;

/// The functionals at a corner; affine, so that barycentrics interpolate them.
struct Corner {
    Point<double> p;
    double s, t, w;
};

/// Sums a piece of the image under a weight of places.
template <class Weight>
class Sum {
  public:
    Sum(const Homography<double>& cell, std::span<const Node> rule, Weight weight)
        : cell_(cell), rule_(rule), weight_(weight) {}

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

    const BilinearMoments& moments() const { return sum_; }

  private:
    Corner corner(const Point<double>& p) const {
        return {p, cell_.u.at(p.x, p.y), cell_.v.at(p.x, p.y), cell_.w.at(p.x, p.y)};
    }

    void add_fan(const Polygon<double>& piece) {
        const Corner hub = corner(piece[0]);
        Corner from = corner(piece[1]);
        for (std::size_t i = 2; i < piece.size(); ++i) {
            const Corner to = corner(piece[i]);
            add_triangle({hub, from, to});
            from = to;
        }
    }

    void add_triangle(const std::array<Corner, 3>& c) {
        BilinearMoments mean;
        for (const Node& n : rule_) {
            const auto blend = [&](double f, double g, double h) { return n.a * f + n.b * g + n.c * h; };
            const Point<double> p{blend(c[0].p.x, c[1].p.x, c[2].p.x), blend(c[0].p.y, c[1].p.y, c[2].p.y)};
            const double share = n.weight * weight_(p);
            const double per_w = 1 / blend(c[0].w, c[1].w, c[2].w);
            const double s = blend(c[0].s, c[1].s, c[2].s) * per_w, t = blend(c[0].t, c[1].t, c[2].t) * per_w;
            mean.one += share;
            mean.s += share * s;
            mean.t += share * t;
            mean.st += share * (s * t);
        }
        const double area = area_of(Polygon<double>{c[0].p, c[1].p, c[2].p});
        sum_.one += area * mean.one;
        sum_.s += area * mean.s;
        sum_.t += area * mean.t;
        sum_.st += area * mean.st;
    }

    const Homography<double>& cell_;
    std::span<const Node> rule_;
    Weight weight_;
    BilinearMoments sum_;
};

}  // namespace

BilinearMoments bilinear_moments(const Polygon<double>& piece, const Homography<double>& cell) {
    Sum sum(cell, rule_of_degree_5(), [](const Point<double>&) { return 1.0; });
    sum.add_piece(piece);
    return sum.moments();
}

BilinearMoments weighted_moments(const Polygon<double>& piece, const Homography<double>& cell,
                                 const PixelWeight& weight) {
    Sum sum(cell, weight.rule, weight.at);
    sum.add_piece(piece);
    return sum.moments();
}

bool WholeCellMoments::holds_for(std::int64_t row, std::int64_t first, std::int64_t last) const {
    const Affine<double> z = lattice_.z();
    const double slope = std::abs(z.a) + std::abs(z.b);
    const double at_first = std::min(z.at(double(first), double(row)), z.at(double(first), double(row + 1)));
    const double at_last = std::min(z.at(double(last), double(row)), z.at(double(last), double(row + 1)));
    return slope <= most_variation * std::min(at_first, at_last);
}

/// With x = p s' + q t' on the cell [-1/2, 1/2]^2 round its centre, 1 / Z^3 = (1 - 3 x + 6 x^2 - 10 x^3 + 15
/// x^4 ...) / Z_c^3, and the means of s'^2, s'^4 are 1/12, 1/80.
BilinearMoments WholeCellMoments::of(const Cell& cell) const {
    const Affine<double> z = lattice_.z();
    const double per_z = 1 / z.at(double(cell.column) + 0.5, double(cell.row) + 0.5);
    const double p = z.a * per_z, q = z.b * per_z, pp = p * p, qq = q * q;
    const double scale = lattice_.per_det() * (per_z * per_z * per_z);
    const double one = scale * (1 + (pp + qq) / 2 + 3.0 / 16 * (pp * pp + qq * qq) + 5.0 / 8 * (pp * qq));
    const double s = -scale * p * (1.0 / 4 + pp / 8 + 5.0 / 24 * qq);
    const double t = -scale * q * (1.0 / 4 + qq / 8 + 5.0 / 24 * pp);
    const double st = scale * (p * q) * (1.0 / 12 + (pp + qq) / 16);
    return {one, s + one / 2, t + one / 2, st + (s + t) / 2 + one / 4};
}

}  // namespace zproof::oracle::area
