#include "compare/bounds/plane_equation.h"

#include <algorithm>
#include <cmath>

#include "compare/bounds/depth_terms.h"
#include "math/rounding.h"

namespace zproof {

namespace {

constexpr double u_float32 = unit_roundoff_float32;
constexpr PlaneEquationBounds unknown{.z_error = unlimited, .spread = 1};
constexpr double underflow = 16 * 0x1p-126;  ///< what 16 results, flushed to zero, may lack

/// A point before the divide, relative to the eye: for perspective (x, y) = depth times the place in the
/// window.
struct ClipPoint {
    double x = 0, y = 0, depth = 0;
};

using ClipPolygon = std::vector<ClipPoint>;

/// Keeps the side where `distance` is not negative.
template <class Distance>
ClipPolygon clipped(const ClipPolygon& polygon, const Distance& distance) {
    ClipPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = distance(p), at_q = distance(q);
        if (at_p >= 0) kept.push_back(p);
        if ((at_p >= 0) == (at_q >= 0)) continue;
        const double t = at_p / (at_p - at_q);
        kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.depth + t * (q.depth - p.depth)});
    }
    return kept;
}

/// Corners in window units, before the divide.
ClipPolygon corners_before_divide(const Camera& c, const TriangleExtent& extent) {
    ClipPolygon corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const double depth = extent.size.depth[i];
        corners.push_back({glm::dot(c.right, extent.v_world[i]) - c.shear.x * depth,
                           glm::dot(c.up, extent.v_world[i]) - c.shear.y * depth, depth});
    }
    return corners;
}

ClipPolygon inside_window(const Camera& c, ClipPolygon polygon, const Window& w) {
    const bool perspective = c.projection == Projection::perspective;
    const auto scale = [&](const ClipPoint& p) { return perspective ? p.depth : 1; };
    polygon = clipped(polygon, [&](const ClipPoint& p) { return p.x - w.left * scale(p); });
    polygon = clipped(polygon, [&](const ClipPoint& p) { return w.right * scale(p) - p.x; });
    polygon = clipped(polygon, [&](const ClipPoint& p) { return p.y - w.bottom * scale(p); });
    return clipped(polygon, [&](const ClipPoint& p) { return w.top * scale(p) - p.y; });
}

ClipPolygon after_clipping(const View& view, ClipPolygon polygon, Clipping clipping) {
    const Camera& c = view.camera;
    polygon = clipped(polygon, [&](const ClipPoint& p) { return p.depth - c.near_depth; });
    if (std::isfinite(c.far_depth))
        polygon = clipped(polygon, [&](const ClipPoint& p) { return c.far_depth - p.depth; });
    return inside_window(c, polygon, clipping == Clipping::guard_band ? guard_band_of(view) : c.window);
}

struct Vector2 {
    double x = 0, y = 0;
};

/// All triangles of three corners.
template <class Act>
void for_each_triangle(std::span<const WindowCorner> polygon, const Act& act) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = i + 1; j < polygon.size(); ++j)
            for (std::size_t k = j + 1; k < polygon.size(); ++k) act(polygon[i], polygon[j], polygon[k]);
}

/// One triangle of the window, as Cramer's rule meets it: edges e1 = p0 - p1 and e2 = p2 - p0 with their
/// rises in z.
class PlaneEquation {
  public:
    PlaneEquation(const WindowCorner& p0, const WindowCorner& p1, const WindowCorner& p2,
                  const CornerShift& shift)
        : shift_(shift),
          e1_{p0.x - p1.x, p0.y - p1.y},
          e2_{p2.x - p0.x, p2.y - p0.y},
          rise1_(p0.z - p1.z),
          rise2_(p2.z - p0.z),
          z_max_(std::max({std::abs(p0.z), std::abs(p1.z), std::abs(p2.z)})) {
        x_max_ = std::max({std::abs(p0.x), std::abs(p1.x), std::abs(p2.x)});
        y_max_ = std::max({std::abs(p0.y), std::abs(p1.y), std::abs(p2.y)});
    }

    PlaneEquationBounds bounds(const View& view) const {
        const double drift = shift_.drift_px;
        const double around = length(e1_) + length(e2_) + length({e1_.x + e2_.x, e1_.y + e2_.y});
        const double area = std::abs(e1_.x * e2_.y - e1_.y * e2_.x) -
                            2 * drift * (length(e1_) + length(e2_)) - 8 * drift * drift;
        if (!(area > 0)) return unknown;
        const Vector2 a1 = widen(e1_), a2 = widen(e2_);
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
        Vector2 a1, a2;
    };

    static double length(const Vector2& v) { return std::abs(v.x) + std::abs(v.y); }
    Vector2 widen(const Vector2& e) const {
        return {std::abs(e.x) + 2 * shift_.drift_px, std::abs(e.y) + 2 * shift_.drift_px};
    }

    /// The value of a gradient's component and the sum of its terms' absolute values, each at its largest.
    struct Gradient {
        double most, terms;
    };
    Gradient gradient(double e1, double e2, double a1, double a2, double area) const {
        const double rise1 = std::abs(rise1_) + 2 * corner(), rise2 = std::abs(rise2_) + 2 * corner();
        const double moved = 2 * shift_.drift_px * (rise1 + rise2) + 2 * corner() * (a1 + a2);
        return {(std::abs(rise1_ * e2 - rise2_ * e1) + moved) / area, (rise1 * a2 + rise2 * a1) / area};
    }
    /// The error of a corner's z, from division and viewport.
    double corner() const { return gamma(4, u_float32) * std::max(z_max_, shift_.least_z_term); }

    double z_error(const View& view, const Shape& s) const {
        const double span = std::max({std::abs(rise1_), std::abs(rise2_), std::abs(rise1_ + rise2_)});
        const double sixfold = gamma(6, u_float32) * (1 + s.lost);
        const Gradient dx = gradient(e1_.y, e2_.y, s.a1.y, s.a2.y, s.area);
        const Gradient dy = gradient(e1_.x, e2_.x, s.a1.x, s.a2.x, s.area);
        const double reach = shift_.snap_px + 2 * shift_.drift_px;
        const double across = s.a1.x + s.a2.x + reach, down = s.a1.y + s.a2.y + reach;
        const double slope_x = (1 + s.lost) * dx.most + sixfold * dx.terms;
        const double slope_y = (1 + s.lost) * dy.most + sixfold * dy.terms;
        return s.spread * (corner() + s.lost * span) + sixfold * (dx.terms * across + dy.terms * down) +
               gamma(8, u_float32) *
                   (z_max_ + slope_x * (x_max_ + view.width) + slope_y * (y_max_ + view.height)) +
               underflow;
    }

    CornerShift shift_;
    Vector2 e1_, e2_;
    double rise1_, rise2_, z_max_, x_max_, y_max_;
};

}  // namespace

Window guard_band_of(const View& view) {
    const Window& w = view.camera.window;
    const double u_per_px = (w.right - w.left) / view.width, v_per_px = (w.top - w.bottom) / view.height;
    const double reach_u = guard_band_px * u_per_px, reach_v = guard_band_px * v_per_px;
    return {.left = w.left - reach_u,
            .right = w.left + reach_u,
            .bottom = w.top - reach_v,
            .top = w.top + reach_v};
}

std::vector<WindowCorner> window_polygon(const View& view, const TriangleExtent& extent, Clipping clipping,
                                         const ZRange& z) {
    const Camera& c = view.camera;
    const Window& w = c.window;
    const bool perspective = c.projection == Projection::perspective;
    std::vector<WindowCorner> corners;
    for (const ClipPoint& p : after_clipping(view, corners_before_divide(c, extent), clipping)) {
        const double scale = perspective ? p.depth : 1, inverse_depth = perspective ? 1 / p.depth : -p.depth;
        corners.push_back({(p.x / scale - w.left) / (w.right - w.left) * view.width,
                           (w.top - p.y / scale) / (w.top - w.bottom) * view.height, z.at(inverse_depth),
                           inverse_depth});
    }
    return corners;
}

PlaneEquationBounds plane_equation_bounds(std::span<const WindowCorner> polygon, const CornerShift& shift,
                                          const View& view) {
    if (polygon.size() < 3) return unknown;
    PlaneEquationBounds worst;
    const auto consider = [&](const WindowCorner& p0, const WindowCorner& p1, const WindowCorner& p2) {
        const PlaneEquationBounds one = PlaneEquation(p0, p1, p2, shift).bounds(view);
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

WindowAreas window_areas(std::span<const WindowCorner> polygon, const EdgeShift& shift, double unit) {
    if (polygon.size() < 3) return {};
    WindowAreas areas{.least_px2 = unlimited};
    const double drift = shift.drift_px;
    const auto consider = [&](const WindowCorner& p, const WindowCorner& q, const WindowCorner& r) {
        const Vector2 e1{p.x - q.x, p.y - q.y}, e2{r.x - p.x, r.y - p.y};
        const double ahead = e1.x * e2.y, across = e1.y * e2.x;
        const double around = std::abs(e1.x) + std::abs(e1.y) + std::abs(e2.x) + std::abs(e2.y);
        const double moved = 2 * drift * around + 8 * drift * drift;
        const double left = std::abs(ahead - across) - moved;
        areas.least_px2 = std::min(areas.least_px2, left / 2);
        const double terms = std::abs(ahead) + std::abs(across) + moved;
        areas.of_area = std::max(areas.of_area, left > 0 ? gamma(4, unit) * terms / left : unlimited);
        // a point inside lies no farther from an edge's corner than the triangle reaches
        const double reach = 2 * (drift + shift.edges_px);
        const Vector2 extent{std::max({std::abs(e1.x), std::abs(e2.x), std::abs(e1.x + e2.x)}) + reach,
                             std::max({std::abs(e1.y), std::abs(e2.y), std::abs(e1.y + e2.y)}) + reach};
        const double of_edges = gamma(4, unit) * 6 * extent.x * extent.y;  // three edges, two products each
        areas.of_weights = std::max(areas.of_weights, left > 0 ? of_edges / left : unlimited);
    };
    for_each_triangle(polygon, consider);
    return areas;
}

}  // namespace zproof
