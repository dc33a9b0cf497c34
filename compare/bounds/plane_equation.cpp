#include "compare/bounds/plane_equation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/bounds/triangle_bounds.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double u_float32 = unit_roundoff_float32;
constexpr PlaneEquationBounds unknown{.z_error = unlimited, .spread = 1};

/// Points before the divide, relative to the eye: place in the window (for perspective times the depth), and
/// depth as z.
using ClipPolygon = std::vector<glm::dvec3>;

/// Keeps the side where `distance` is not negative.
template <class Distance>
ClipPolygon clipped(const ClipPolygon& polygon, const Distance& distance) {
    ClipPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = distance(p), at_q = distance(q);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) == (at_q >= 0)) continue;
        kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    return kept;
}

ClipPolygon inside_window(const Camera& c, ClipPolygon polygon, const Window& w) {
    const bool perspective = c.projection == Projection::perspective;
    const auto scale = [&](const glm::dvec3& p) { return perspective ? p.z : 1; };
    polygon = clipped(polygon, [&](const glm::dvec3& p) { return p.x - w.left * scale(p); });
    polygon = clipped(polygon, [&](const glm::dvec3& p) { return w.right * scale(p) - p.x; });
    polygon = clipped(polygon, [&](const glm::dvec3& p) { return p.y - w.bottom * scale(p); });
    return clipped(polygon, [&](const glm::dvec3& p) { return w.top * scale(p) - p.y; });
}

/// A triangle that lies wholly beyond near or far is left as it is: rounding may show it, if it is close.
ClipPolygon after_clipping(const ViewFacts& facts, const TriangleExtent& extent, Clipping clipping) {
    const Camera& c = facts.view.camera;
    ClipPolygon triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.emplace_back(facts.before_divide(extent, i), extent.size.depth[i]);
    ClipPolygon polygon = clipped(triangle, [&](const glm::dvec3& p) { return p.z - c.near_depth; });
    if (std::isfinite(c.far_depth))
        polygon = clipped(polygon, [&](const glm::dvec3& p) { return c.far_depth - p.z; });
    const bool is_before_eye = c.projection == Projection::parallel ||
                               std::ranges::all_of(triangle, [](const glm::dvec3& p) { return p.z > 0; });
    if (polygon.empty() && is_before_eye) polygon = triangle;
    return inside_window(c, polygon, clip_window_of(facts.view, clipping));
}

double length_px(const glm::dvec2& v) { return std::abs(v.x) + std::abs(v.y); }

/// One triangle of the window, as Cramer's rule meets it: edges e1 = p0 - p1 and e2 = p2 - p0 with their
/// rises in z.
class PlaneEquation {
  public:
    PlaneEquation(const WindowCorner& p0, const WindowCorner& p1, const WindowCorner& p2,
                  const CornerShift& shift, CornerSigns signs)
        : shift_(shift),
          e1_{p0.x - p1.x, p0.y - p1.y},
          e2_{p2.x - p0.x, p2.y - p0.y},
          signs_(signs),
          rise1_(rise(p1.z, p0.z)),
          rise2_(rise(p0.z, p2.z)),
          span_(std::max({std::abs(rise1_), std::abs(rise2_), std::abs(rise(p1.z, p2.z))})),
          z_max_(std::max({std::abs(p0.z), std::abs(p1.z), std::abs(p2.z)})) {
        x_max_ = std::max({std::abs(p0.x), std::abs(p1.x), std::abs(p2.x)});
        y_max_ = std::max({std::abs(p0.y), std::abs(p1.y), std::abs(p2.y)});
    }

    PlaneEquationBounds bounds(const View& view) const {
        const double drift = moved_px();
        const double around = length_px(e1_) + length_px(e2_) + length_px({e1_.x + e2_.x, e1_.y + e2_.y});
        const double area = std::abs(e1_.x * e2_.y - e1_.y * e2_.x) -
                            2 * drift * (length_px(e1_) + length_px(e2_)) - 8 * drift * drift;
        if (!(area > 0)) return unknown;
        const glm::dvec2 a1 = widen(e1_), a2 = widen(e2_);
        const double of_area = gamma(4, u_float32) * (a1.x * a2.y + a1.y * a2.x) / area;
        if (!(of_area < 1)) return unknown;
        const double lost = of_area / (1 - of_area);
        const double spread = 1 + shift_.snap_px * (around + 6 * drift) / area;
        return {z_error(view, {area, lost, spread, a1, a2}), spread};
    }

  private:
    /// What does not depend on z.
    struct Shape {
        double area;    ///< twice it, the least that rounding leaves
        double lost;    ///< relative error of the gradients by that of the area
        double spread;  ///< see PlaneEquationBounds
        glm::dvec2 a1, a2;
    };

    /// The plane may be that of the snapped corners.
    double moved_px() const { return shift_.snap_px + shift_.drift_px; }
    double rise(double from, double to) const {
        return signs_ == CornerSigns::known ? to - from : std::abs(to) + std::abs(from);
    }
    glm::dvec2 widen(const glm::dvec2& e) const {
        return {std::abs(e.x) + 2 * moved_px(), std::abs(e.y) + 2 * moved_px()};
    }

    /// The value of a gradient's component and the sum of its terms' absolute values, each at its largest.
    struct Gradient {
        double most, terms;
    };
    Gradient gradient(double e1, double e2, double a1, double a2, double area) const {
        const double rise1 = std::abs(rise1_) + 2 * corner(), rise2 = std::abs(rise2_) + 2 * corner();
        const double moved = 2 * moved_px() * (rise1 + rise2) + 2 * corner() * (a1 + a2);
        const double numerator = signs_ == CornerSigns::known ? std::abs(rise1_ * e2 - rise2_ * e1)
                                                              : std::abs(rise1_ * e2) + std::abs(rise2_ * e1);
        return {(numerator + moved) / area, (rise1 * a2 + rise2 * a1) / area};
    }
    /// The error of a corner's z, from division and viewport.
    double corner() const { return gamma(4, u_float32) * std::max(z_max_, shift_.least_z_term); }

    double z_error(const View& view, const Shape& s) const {
        const double sixfold = gamma(6, u_float32) * (1 + s.lost);
        const Gradient dx = gradient(e1_.y, e2_.y, s.a1.y, s.a2.y, s.area);
        const Gradient dy = gradient(e1_.x, e2_.x, s.a1.x, s.a2.x, s.area);
        const double reach = shift_.snap_px + 2 * moved_px();
        const double across = s.a1.x + s.a2.x + reach, down = s.a1.y + s.a2.y + reach;
        const double slope_x = (1 + s.lost) * dx.most + sixfold * dx.terms;
        const double slope_y = (1 + s.lost) * dy.most + sixfold * dy.terms;
        return s.spread * (corner() + s.lost * span_) + sixfold * (dx.terms * across + dy.terms * down) +
               gamma(8, u_float32) *
                   (z_max_ + slope_x * (x_max_ + view.width) + slope_y * (y_max_ + view.height)) +
               underflow_of_plane;
    }

    CornerShift shift_;
    glm::dvec2 e1_, e2_;
    CornerSigns signs_;
    double rise1_, rise2_, span_, z_max_, x_max_, y_max_;
};

/// What the weights of one triangle in the window err by.
class WeightErrors {
  public:
    WeightErrors(const std::array<WindowCorner, 3>& corners, const EdgeShift& shift, const WeightForm& form)
        : form_(form), drift_(shift.drift_px) {
        for (std::size_t i = 0; i < 3; ++i) {
            const WindowCorner &from = corners[i], &to = corners[(i + 1) % 3];
            edge_[i] = {std::abs(to.x - from.x), std::abs(to.y - from.y)};
        }
        const auto& [p, q, r] = corners;
        const double ahead = (p.x - q.x) * (r.y - p.y), across = (p.y - q.y) * (r.x - p.x);
        const double moved = 2 * drift_ * (length_px(edge_[0]) + length_px(edge_[2])) + 8 * drift_ * drift_;
        least_area_ = form.may_vanish ? 0 : std::abs(ahead - across) - moved;
        largest_area_ = std::abs(ahead - across) + moved;
        if (!form.is_rounded()) return;
        of_area_ = gamma(4, form.unit) * (std::abs(ahead) + std::abs(across) + moved);
        // a point inside lies no farther from an edge's corner than the triangle reaches
        const double reach = 2 * (drift_ + shift.edges_px);
        const double x = std::max({edge_[0].x, edge_[1].x, edge_[2].x}) + reach,
                     y = std::max({edge_[0].y, edge_[1].y, edge_[2].y}) + reach;
        of_edge_.fill(gamma(4, form.unit) * 2 * x * y);
        if (has_coefficients()) set_coefficients(corners);
    }

    double least_area_px2() const { return least_area_ / 2; }
    /// A factor that all weights have in common.
    double of_area() const { return is_remainder() ? 0 : of_quotient(); }
    double of_weights() const {
        const double sum = of_edge_[0] + of_edge_[1] + of_edge_[2];
        return is_remainder() ? 2 * of_two_weights(sum - std::ranges::min(of_edge_)) : share(sum);
    }
    double edges_px() const {
        double largest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double own = has_coefficients() ? of_edge_[i] : 0, slope = length_px(edge_[i]) - 4 * drift_;
            // the third weight's error is a share of the height; beyond the edge, the others err by more
            const double others = of_two_weights(of_edge_[(i + 1) % 3] + of_edge_[(i + 2) % 3]);
            const double error =
                std::max(own, is_remainder() ? compounded(2 * others) / 2 * largest_area_ : 0);
            const bool is_known = slope > 0 && !form_.may_vanish;  // what is left may be of any shortness
            if (error > 0) largest = std::max(largest, is_known ? error / slope : unlimited);
        }
        return largest;
    }

  private:
    /// a x + b y + c: a and b have 1 rounding, c has 2; 3 more at most on the way to the sum.
    void set_coefficients(const std::array<WindowCorner, 3>& corners) {
        const auto size = [&](const WindowCorner& p) {  // y may run down or up
            return glm::dvec2{std::abs(p.x) + drift_,
                              std::max(std::abs(p.y), std::abs(form_.height - p.y)) + drift_};
        };
        const double rounding = gamma(4, form_.unit);
        of_area_ = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 from = size(corners[i]), to = size(corners[(i + 1) % 3]),
                             opposite = size(corners[(i + 2) % 3]);
            const double a = edge_[i].y + 2 * drift_, b = edge_[i].x + 2 * drift_,
                         c = from.x * to.y + to.x * from.y;
            of_edge_[i] = rounding * (a * form_.width + b * form_.height + c);
            of_area_ = std::max(of_area_, rounding * (a * opposite.x + b * opposite.y + c));
        }
    }
    bool has_coefficients() const { return form_.edge_functions == EdgeFunctions::window_coefficients; }
    bool is_remainder() const { return form_.is_rounded() && form_.third_weight == ThirdWeight::remainder; }
    double share(double error) const {
        return error == 0 ? 0 : least_area_ > 0 ? error / least_area_ : unlimited;
    }
    double of_quotient() const { return share(of_area_ + 2 * form_.area_epsilon_px2); }
    /// Both are at most 1 together: that share of them is their quotients' error, and 1 less them is rounded.
    double of_two_weights(double of_edges) const {
        return share(of_edges) + of_quotient() + gamma(3, form_.unit);
    }

    const WeightForm& form_;
    double drift_, least_area_, largest_area_, of_area_ = 0;  ///< twice the areas
    std::array<glm::dvec2, 3> edge_;
    std::array<double, 3> of_edge_{};
};

}  // namespace

Window clip_window_of(const View& view, Clipping clipping) {
    const Window& w = view.camera.window;
    if (clipping == Clipping::view_volume) return w;
    const double u_per_px = (w.right - w.left) / view.width, v_per_px = (w.top - w.bottom) / view.height;
    const double reach_u = guard_band_px * u_per_px, reach_v = guard_band_px * v_per_px;
    return {.left = w.left - reach_u,
            .right = w.left + reach_u,
            .bottom = w.top - reach_v,
            .top = w.top + reach_v};
}

std::vector<WindowCorner> window_polygon(const ViewFacts& facts, const TriangleExtent& extent,
                                         Clipping clipping, const ZRange& z) {
    const View& view = facts.view;
    const Window& w = view.camera.window;
    std::vector<WindowCorner> corners;
    for (const glm::dvec3& p : after_clipping(facts, extent, clipping)) {
        const double scale = facts.perspective ? p.z : 1, inverse_depth = facts.perspective ? 1 / p.z : -p.z;
        corners.push_back({(p.x / scale - w.left) / (w.right - w.left) * view.width,
                           (w.top - p.y / scale) / (w.top - w.bottom) * view.height, z.at(inverse_depth),
                           inverse_depth});
    }
    return corners;
}

PlaneEquationBounds plane_equation_bounds(std::span<const WindowCorner> polygon, const CornerShift& shift,
                                          const View& view, CornerSigns signs) {
    if (polygon.size() < 3) return unknown;
    PlaneEquationBounds worst;
    const auto consider = [&](const WindowCorner& p0, const WindowCorner& p1, const WindowCorner& p2) {
        const PlaneEquationBounds one = PlaneEquation(p0, p1, p2, shift, signs).bounds(view);
        worst.z_error = std::max(worst.z_error, one.z_error);
        worst.spread = std::max(worst.spread, one.spread);
    };
    for_each_triangle(polygon, [&](const WindowCorner& p, const WindowCorner& q, const WindowCorner& r) {
        consider(p, q, r);
        consider(q, r, p);
        consider(r, p, q);
    });
    return worst;
}

WindowAreas window_areas(std::span<const WindowCorner> polygon, const EdgeShift& shift,
                         const WeightForm& form) {
    if (polygon.size() < 3) return {};
    WindowAreas areas{.least_px2 = unlimited};
    for_each_triangle(polygon, [&](const WindowCorner& p, const WindowCorner& q, const WindowCorner& r) {
        const WeightErrors errors({p, q, r}, shift, form);
        areas.least_px2 = std::min(areas.least_px2, errors.least_area_px2());
        areas.of_area = std::max(areas.of_area, errors.of_area());
        areas.of_weights = std::max(areas.of_weights, errors.of_weights());
        areas.edges_px = std::max(areas.edges_px, errors.edges_px());
    });
    areas.edges_px = std::min(areas.edges_px, form.width + form.height);
    return areas;
}

}  // namespace zproof
