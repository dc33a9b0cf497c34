#include "rasterizer/ray_cones.h"

#include <cmath>

namespace zproof::rasterizer {

namespace {

/// The height of one row of pixels, at depth 1 in perspective. The spread angle alpha is its arc tangent, and
/// tan(alpha / 2) = p / (1 + sqrt(1 + p^2)).
double radius_of(const View& view) {
    const Camera& camera = view.camera;
    const double pixel = (camera.window.top - camera.window.bottom) / view.height;
    return camera.projection == Projection::perspective ? pixel / (1 + std::hypot(1, pixel)) : pixel / 2;
}

}  // namespace

RayCones::RayCones(const View& view, const std::array<TexturedCorner, 3>& corners)
    : rays_{pixel_rays(view)}, projection_{view.camera.projection}, radius_{radius_of(view)} {
    const auto& [a, b, c] = corners;
    const glm::dvec3 ab = b.from_eye - a.from_eye, ac = c.from_eye - a.from_eye, area = glm::cross(ab, ac);
    normal_ = glm::normalize(area);
    any_direction_ = glm::normalize(ab);
    plane_distance_ = glm::dot(normal_, a.from_eye);
    const double twice_the_area = glm::length(area);
    const glm::dvec3 share_of_b = glm::cross(ac, normal_) / twice_the_area,
                     share_of_c = glm::cross(normal_, ab) / twice_the_area;
    const glm::dvec2 to_b = b.texel - a.texel, to_c = c.texel - a.texel;
    u_gradient_ = to_b.x * share_of_b + to_c.x * share_of_c;
    v_gradient_ = to_b.y * share_of_b + to_c.y * share_of_c;
}

texture::ConeEllipse RayCones::at(const glm::dvec2& p) const {
    const glm::dvec3 ray = glm::normalize(rays_.origin.to + p.x * rays_.per_x.to + p.y * rays_.per_y.to);
    const double towards = glm::dot(normal_, ray), cosine = std::abs(towards);
    const double radius =
        projection_ == Projection::perspective ? radius_ * (plane_distance_ / towards) : radius_;
    const glm::dvec3 projected = ray - towards * normal_;
    const double sine = glm::length(projected);
    const glm::dvec3 along = sine > 0 ? projected / sine : any_direction_;  // square on, each is as good
    return {texels(radius / cosine * along), texels(radius * glm::cross(normal_, along)), cosine};
}

}  // namespace zproof::rasterizer
