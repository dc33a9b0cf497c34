#include "compare/truth/image_of_view.h"

#include <cmath>

namespace zproof {

ImageOfView::ImageOfView(const Sight<double>& any, const CornersWorld& p_world)
    : p_world_(corners<double>(p_world)), is_kept_(any.projection == Projection::perspective) {
    if (!is_kept_) return;
    const Vector3<double> v0 = p_world_[0] - any.origin, v1 = p_world_[1] - any.origin,
                          v2 = p_world_[2] - any.origin;
    plane_.normal = cross(v1 - v0, v2 - v0);
    const double volume = dot(v0, plane_.normal);
    orientation_ = sign(volume);
    is_edge_on_ = orientation_ == 0;
    if (is_edge_on_) return;
    moment_ = {cross(v1, v2), cross(v2, v0), cross(v0, v1)};
    plane_.volume_reciprocal = 1 / volume;
    for (std::size_t i = 0; i < 3; ++i) at_any_.edge[i] = detail::perspective_functional(any, moment_[i]);
    at_any_ = detail::oriented(at_any_, orientation_);
    at_any_.nearness = plane_.volume_reciprocal * detail::perspective_functional(any, plane_.normal);
    plane_.gradient = std::abs(at_any_.nearness.a) + std::abs(at_any_.nearness.b);
}

std::optional<TriangleImage<double>> ImageOfView::at(const Sight<double>& sight) const {
    if (!is_kept_) return image_of(sight, p_world_);
    if (is_edge_on_) return std::nullopt;
    TriangleImage<double> image = at_any_;
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = dot(moment_[i], sight.direction);
        image.edge[i].c = orientation_ < 0 ? -value : value;
    }
    image.nearness.c = nearness_at(sight);
    return image;
}

std::optional<Affine<double>> ImageOfView::nearness(const Sight<double>& sight) const {
    if (!is_kept_) return nearness_of(sight, p_world_);
    if (is_edge_on_) return std::nullopt;
    return Affine<double>{at_any_.nearness.a, at_any_.nearness.b, nearness_at(sight)};
}

double ImageOfView::nearness_at(const Sight<double>& sight) const {
    if (!is_kept_) return nearness_of(sight, p_world_)->c;
    return plane_.nearness_at(sight.direction);
}

}  // namespace zproof
