#include "compare/diagnosis/hypotheses/affine_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace zproof {

namespace {

/// A corner as it is drawn: raster position from where the pixel is sampled, px, and depth.
struct RasterCorner {
    double x, y, depth;
};

using CameraPolygon = std::vector<glm::dvec3>;  ///< right, up, depth

CameraPolygon clipped(const CameraPolygon& polygon, double plane_depth, double side) {
    CameraPolygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double from_p = side * (p.z - plane_depth), from_q = side * (q.z - plane_depth);
        if (from_p >= 0) kept.push_back(p);
        if ((from_p >= 0) != (from_q >= 0)) kept.push_back(p + from_p / (from_p - from_q) * (q - p));
    }
    return kept;
}

std::vector<RasterCorner> drawn_corners(const View& view, int x, int y, const CornersWorld& p_world) {
    const Camera& c = view.camera;
    CameraPolygon polygon;
    for (const glm::vec3& p : p_world) {
        const glm::dvec3 v = glm::dvec3(p) - glm::dvec3(c.eye_world);
        polygon.emplace_back(dot(c.right, v), dot(c.up, v), -dot(c.back, v));
    }
    polygon = clipped(clipped(polygon, c.near_depth, 1), c.far_depth, -1);
    const double px_per_u = view.width / (c.window.right - c.window.left);
    const double px_per_v = view.height / (c.window.top - c.window.bottom);
    const glm::dvec2 at = sampled_at(view, x, y);
    std::vector<RasterCorner> corners;
    for (const glm::dvec3& p : polygon)
        corners.push_back({(p.x / p.z - c.window.left) * px_per_u - at.x,
                           (c.window.top - p.y / p.z) * px_per_v - at.y, p.z});
    return corners;
}

/// Widens `range` by the plane through three corners, over the square of half-side eps, if the square meets
/// the triangle.
void add(ReportedDepth& range, const std::array<RasterCorner, 3>& p, double eps_px) {
    const double ux = p[1].x - p[0].x, uy = p[1].y - p[0].y, vx = p[2].x - p[0].x, vy = p[2].y - p[0].y;
    const double area = ux * vy - uy * vx;
    if (area == 0) return;
    for (std::size_t i = 0; i < 3; ++i) {
        const RasterCorner &from = p[i], &to = p[(i + 1) % 3];
        const double ex = to.x - from.x, ey = to.y - from.y;
        const double inside = (ey * from.x - ex * from.y) * (area > 0 ? 1 : -1);
        if (inside + eps_px * (std::abs(ex) + std::abs(ey)) < 0) return;
    }
    const double du = p[1].depth - p[0].depth, dv = p[2].depth - p[0].depth;
    const double slope_x = (du * vy - dv * uy) / area, slope_y = (dv * ux - du * vx) / area;
    const double here = p[0].depth - slope_x * p[0].x - slope_y * p[0].y;
    const double shift = eps_px * (std::abs(slope_x) + std::abs(slope_y));
    const auto [least, greatest] = std::minmax({p[0].depth, p[1].depth, p[2].depth});
    range.low = std::min(range.low, std::clamp(here - shift, least, greatest));
    range.high = std::max(range.high, std::clamp(here + shift, least, greatest));
}

}  // namespace

ReportedDepth affine_depth(const View& view, int x, int y, const Neighbour& triangle) {
    const std::vector<RasterCorner> p = drawn_corners(view, x, y, triangle.p_world);
    ReportedDepth range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = i + 1; j < p.size(); ++j)
            for (std::size_t k = j + 1; k < p.size(); ++k)
                add(range, {p[i], p[j], p[k]}, triangle.bounds.eps_px);
    if (range.low > range.high) return {triangle.nearest, triangle.farthest};
    const double r = triangle.bounds.depth_relative, a = triangle.bounds.depth_absolute;
    return {range.low * (1 - r) - a, range.high * (1 + r) + a};
}

}  // namespace zproof
