#include "compare/search/image_box.h"

#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

[[gnu::always_inline]] inline Four side_by_side(const CornersWorld& p, int axis) {
    const auto at = [&](std::size_t corner) { return double(p[corner][axis]); };
    return Four{at(0), at(1), at(2), at(2)};
}

[[gnu::always_inline]] inline Four along(const glm::dvec3& axis, const Four& x, const Four& y,
                                         const Four& z) {
    return axis.x * x + axis.y * y + axis.z * z;
}

/// As for one corner. Is there a place for each?
[[gnu::target_clones("default", "avx2")]] bool find_boxes(const BoxProjection::Terms& terms,
                                                          const CornersWorld& p_world, CornerBoxes& boxes) {
    const Camera& c = terms.camera;
    const glm::dvec3 eye(c.eye_world);
    const Four x = side_by_side(p_world, 0) - eye.x, y = side_by_side(p_world, 1) - eye.y,
               z = side_by_side(p_world, 2) - eye.z;
    const Four right = along(c.right, x, y, z), up = along(c.up, x, y, z), depth = -along(c.back, x, y, z);
    if (!holds_in_all(depth >= terms.least_depth)) return false;
    const Four u = terms.perspective ? right / depth : right - c.shear.x * depth;
    const Four v = terms.perspective ? up / depth : up - c.shear.y * depth;
    const Four px = (u - c.window.left) * terms.px_per_u, py = (c.window.top - v) * terms.px_per_v;
    const Four farthest = larger(larger(absolute(px), absolute(py)), everywhere<Four>(65536));
    const Four wider = terms.px_of_rounding * (absolute(x) + absolute(y) + absolute(z)) +
                       16 * unit_roundoff_float64 * farthest;
    boxes = {px - wider, py - wider, px + wider, py + wider};
    return holds_in_all((boxes.left <= boxes.right) & (boxes.top <= boxes.bottom));
}

double size_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

}  // namespace

/// Rounding moves a camera-space corner by at most 4u |v|, and its quotient in the image by 16 times that
/// over the least depth.
BoxProjection::BoxProjection(const View& view)
    : terms_{.camera = view.camera,
             .perspective = view.camera.projection == Projection::perspective,
             .px_per_u = view.width / (view.camera.window.right - view.camera.window.left),
             .px_per_v = view.height / (view.camera.window.top - view.camera.window.bottom),
             .least_depth = -std::numeric_limits<double>::infinity(),
             .px_of_rounding = 64 * unit_roundoff_float64} {
    const Camera& c = view.camera;
    if (terms_.perspective) terms_.least_depth = c.near_depth / 2;
    terms_.px_of_rounding *= (1 + std::abs(c.shear.x) + std::abs(c.shear.y)) *
                             std::max(terms_.px_per_u, terms_.px_per_v) /
                             (terms_.perspective ? terms_.least_depth : 1);
}

std::optional<Box> BoxProjection::operator()(const CornersWorld& p_world) const {
    std::array<glm::dvec3, 3> p_camera;
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 v = glm::dvec3(p_world[i]) - glm::dvec3(terms_.camera.eye_world);
        p_camera[i] = to_camera(v);
        size = std::max(size, size_of(v));
    }
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 &p = p_camera[i], &q = p_camera[(i + 1) % 3];
        if (p.z >= terms_.least_depth) add(box, p);
        if ((p.z >= terms_.least_depth) != (q.z >= terms_.least_depth))
            add(box, p + (terms_.least_depth - p.z) / (q.z - p.z) * (q - p));
    }
    if (!(box.left <= box.right)) return std::nullopt;
    return widened(box, size);
}

std::optional<Box> BoxProjection::operator()(const glm::vec3& p_world) const {
    const glm::dvec3 v = glm::dvec3(p_world) - glm::dvec3(terms_.camera.eye_world);
    const glm::dvec3 p_camera = to_camera(v);
    if (!(p_camera.z >= terms_.least_depth)) return std::nullopt;
    Box box;
    add(box, p_camera);
    return box.is_empty() ? std::nullopt : std::optional(widened(box, size_of(v)));
}

std::optional<CornerBoxes> BoxProjection::of_corners(const CornersWorld& p_world) const {
    CornerBoxes boxes;
    return find_boxes(terms_, p_world, boxes) ? std::optional(boxes) : std::nullopt;
}

glm::dvec3 BoxProjection::to_camera(const glm::dvec3& v) const {
    return {dot(terms_.camera.right, v), dot(terms_.camera.up, v), -dot(terms_.camera.back, v)};
}

void BoxProjection::add(Box& box, const glm::dvec3& p) const {
    const double u = terms_.perspective ? p.x / p.z : p.x - terms_.camera.shear.x * p.z;
    const double v = terms_.perspective ? p.y / p.z : p.y - terms_.camera.shear.y * p.z;
    box.add((u - terms_.camera.window.left) * terms_.px_per_u,
            (terms_.camera.window.top - v) * terms_.px_per_v);
}

/// Scaling and the window's offset add a few ulps of the result.
Box BoxProjection::widened(Box box, double size) const {
    const double reach =
        std::max({std::abs(box.left), std::abs(box.right), std::abs(box.top), std::abs(box.bottom), 65536.0});
    box.widen(terms_.px_of_rounding * size + 16 * unit_roundoff_float64 * reach);
    return box;
}

}  // namespace zproof
