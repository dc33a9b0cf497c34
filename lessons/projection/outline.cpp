#include "lessons/projection/outline.h"

#include <algorithm>
#include <cmath>

#include "lessons/projection/stages.h"

namespace zproof::study::projection {

namespace {

using Corner = Vector3<double>;

Corner between(const Corner& a, const Corner& b, double share) { return a + share * (b - a); }

/// Keeps what lies where `inside` >= 0, an affine function of the place (Sutherland and Hodgman 1974).
template <class Inside>
std::vector<Corner> cut(const std::vector<Corner>& corners, Inside inside) {
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
        const double at_from = inside(from), at_to = inside(to);
        if (at_from >= 0) kept.push_back(from);
        if ((at_from >= 0) != (at_to >= 0)) kept.push_back(between(from, to, at_from / (at_from - at_to)));
    }
    return kept;
}

double beyond_near(const NumericCamera<double>& camera, const Corner& p) { return -p.z - camera.near; }
double before_far(const NumericCamera<double>& camera, const Corner& p) {
    return camera.has_far ? camera.far + p.z : 1;
}

double side_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

double distance_to(const glm::dvec2& p, const RasterSegment& s) {
    const glm::dvec2 along = s.b - s.a;
    const double square = glm::dot(along, along);
    const double share = square > 0 ? std::clamp(glm::dot(p - s.a, along) / square, 0.0, 1.0) : 0;
    return glm::length(p - (s.a + share * along));
}

bool cross(const RasterSegment& s, const RasterSegment& t) {
    const double a = side_of(s.a, s.b, t.a), b = side_of(s.a, s.b, t.b), c = side_of(t.a, t.b, s.a),
                 d = side_of(t.a, t.b, s.b);
    return ((a < 0) != (b < 0)) && ((c < 0) != (d < 0));
}

bool is_finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

double length_of(const RasterSegment& segment) { return glm::length(segment.b - segment.a); }

double distance_between(const RasterSegment& s, const RasterSegment& t) {
    if (cross(s, t)) return 0;
    return std::min(std::min(distance_to(s.a, t), distance_to(s.b, t)),
                    std::min(distance_to(t.a, s), distance_to(t.b, s)));
}

std::optional<RasterSegment> within(const RasterSegment& segment, const glm::dvec2& low,
                                    const glm::dvec2& high) {
    const glm::dvec2 along = segment.b - segment.a;
    double from = 0, to = 1;
    for (int axis = 0; axis < 2; ++axis)
        for (const auto& [step, room] : {std::pair{-along[axis], segment.a[axis] - low[axis]},
                                         std::pair{along[axis], high[axis] - segment.a[axis]}}) {
            if (step == 0 && room < 0) return std::nullopt;
            if (step < 0) from = std::max(from, room / step);
            if (step > 0) to = std::min(to, room / step);
        }
    if (!(from <= to)) return std::nullopt;
    return RasterSegment{segment.a + from * along, segment.a + to * along};
}

Vector3<double> Outliner::in_camera(const glm::vec3& p_world) const {
    return world_to_camera(camera_, exactly<double>(glm::dvec3(p_world)));
}

glm::dvec2 Outliner::in_raster(const Vector3<double>& p_camera) const {
    const Vector3<double> p =
        ndc_to_raster(camera_, screen_to_ndc(camera_.on_near, camera_to_screen(camera_, p_camera)));
    return {p.x, p.y};
}

std::vector<glm::dvec2> Outliner::outline(PrimitiveId triangle) const {
    const glm::uvec3& t = scene_.triangles[std::size_t(triangle)];
    std::vector<Corner> corners;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3& p = scene_.vertices.position_world[t[i]];
        if (!is_finite(p)) return {};
        corners.push_back(in_camera(p));
    }
    corners = cut(corners, [&](const Corner& p) { return beyond_near(camera_, p); });
    corners = cut(corners, [&](const Corner& p) { return before_far(camera_, p); });
    std::vector<glm::dvec2> outline;
    for (const Corner& corner : corners) outline.push_back(in_raster(corner));
    return outline;
}

std::vector<RasterSegment> Outliner::sides(PrimitiveId triangle) const {
    const std::vector<glm::dvec2> corners = outline(triangle);
    std::vector<RasterSegment> sides;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return sides;
}

std::optional<RasterSegment> Outliner::line(const glm::vec3& a_world, const glm::vec3& b_world) const {
    if (!is_finite(a_world) || !is_finite(b_world)) return std::nullopt;
    Corner a = in_camera(a_world), b = in_camera(b_world);
    for (const auto inside : {beyond_near, before_far}) {
        const double at_a = inside(camera_, a), at_b = inside(camera_, b);
        if (at_a < 0 && at_b < 0) return std::nullopt;
        const Corner border = between(a, b, at_a / (at_a - at_b));
        if (at_a < 0) a = border;
        if (at_b < 0) b = border;
    }
    return RasterSegment{in_raster(a), in_raster(b)};
}

bool Outliner::holds(PrimitiveId triangle, const glm::dvec2& p_raster) const {
    bool is_left = true, is_right = true;
    const std::vector<RasterSegment> all = sides(triangle);
    for (const RasterSegment& s : all) {
        const double side = side_of(s.a, s.b, p_raster);
        is_left = is_left && side >= 0, is_right = is_right && side <= 0;
    }
    return !all.empty() && (is_left || is_right);
}

}  // namespace zproof::study::projection
