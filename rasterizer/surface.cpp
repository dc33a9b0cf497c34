#include "rasterizer/surface.h"

#include <algorithm>
#include <cmath>

namespace zproof::rasterizer {

PixelRay pixel_ray(const View& view, double x_raster, double y_raster) {
    const Camera& c = view.camera;
    const double u = c.window.left + (c.window.right - c.window.left) * x_raster / view.width;
    const double v = c.window.top - (c.window.top - c.window.bottom) * y_raster / view.height;
    const glm::dvec3 across = u * c.right + v * c.up;
    if (c.projection == Projection::perspective) return {.to = across - c.back};
    return {.from = across, .to = c.shear.x * c.right + c.shear.y * c.up - c.back};
}

PixelRays pixel_rays(const View& view) {
    const Camera& c = view.camera;
    const glm::dvec3 per_x = (c.window.right - c.window.left) / view.width * c.right;
    const glm::dvec3 per_y = (c.window.bottom - c.window.top) / view.height * c.up;
    const PixelRay origin = pixel_ray(view, 0, 0);
    if (c.projection == Projection::perspective) return {origin, {.to = per_x}, {.to = per_y}};
    return {origin, {.from = per_x}, {.from = per_y}};
}

Barycentrics barycentrics(const PixelRay& line, const std::array<glm::dvec3, 3>& corners_from_eye) {
    const glm::dvec3 a = corners_from_eye[0] - line.from, b = corners_from_eye[1] - line.from,
                     c = corners_from_eye[2] - line.from;
    const auto weight = [&](const glm::dvec3& p, const glm::dvec3& q) {
        return glm::dot(glm::cross(p, q), line.to);
    };
    const Barycentrics w{weight(b, c), weight(c, a), weight(a, b)};
    const double sum = w[0] + w[1] + w[2];
    // each weight has 5 roundings of products that are no larger than this
    const double product = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)}) * glm::length(line.to);
    if (std::abs(sum) <= 0x1p-49 * product) return {1.0 / 3, 1.0 / 3, 1.0 / 3};
    return {w[0] / sum, w[1] / sum, w[2] / sum};
}

}  // namespace zproof::rasterizer
