#include "compare/admissible/true_visibility.h"

#include <algorithm>
#include <cmath>

namespace zproof {

TrueVisibility::TrueVisibility(const Camera& camera, const SquareInView& square, const Neighbour* answer)
    : square_(square),
      answer_(answer),
      near_(inverse_depth_of(camera.near_depth, camera.projection)),
      far_(inverse_depth_of(camera.far_depth, camera.projection)),
      error_scale_(2 * std::max(1.0, square.half_side_px + std::max(std::abs(square.from_view_ray.x),
                                                                    std::abs(square.from_view_ray.y)))) {}

auto TrueVisibility::range_of(const Affine<double>& f, double error) const -> Range {
    const double middle = f.at(square_.from_view_ray.x, square_.from_view_ray.y),
                 reach = square_.half_side_px * (std::abs(f.a) + std::abs(f.b)) + error_scale_ * error;
    return {middle - reach, middle + reach};
}

/// The plane must be known.
auto TrueVisibility::plane_of(const Neighbour& n) const -> Range {
    return range_of(n.image->inverse_depth, n.plane_error);
}

bool TrueVisibility::is_answer_there() const {
    if (!answer_) return true;
    if (!answer_->is_trusted) return false;
    for (const Affine<double>& edge : answer_->edges)
        if (!(range_of(edge, answer_->edge_error).least > 0)) return false;
    const Range depth = plane_of(*answer_);
    return depth.most < near_ && depth.least > far_;
}

/// Where the sign of a triangle's edges is not certain, edges of both signs must say that it is outside.
bool TrueVisibility::is_outside(const Neighbour& n) const {
    bool is_any_below = false, is_any_above = false;
    for (const Affine<double>& edge : n.edges) {
        const Range range = range_of(edge, n.edge_error);
        is_any_below |= range.most < 0;
        is_any_above |= range.least > 0;
    }
    return is_any_below && (n.is_trusted || is_any_above);
}

bool TrueVisibility::is_seen_past(const Neighbour& other) const {
    if (other.may_be_missing || is_outside(other)) return true;
    if (!other.is_plane_known) return false;
    const Range depth = plane_of(other);
    if (depth.least > near_ || depth.most < far_) return true;  // near or far cuts it away
    return answer_ && range_of(answer_->image->inverse_depth - other.image->inverse_depth,
                               answer_->plane_error + other.plane_error)
                              .least > 0;
}

}  // namespace zproof
