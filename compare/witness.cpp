#include "compare/witness.h"

#include <cmath>

namespace zproof {

bool is_invalid(const Answer& answer, std::size_t triangle_count) {
    if (std::isnan(answer.camera_depth) || answer.camera_depth < 0) return true;
    if (answer.primitive == PrimitiveId::none) return answer.camera_depth != background_depth;
    return std::size_t(answer.primitive) >= triangle_count;
}

TriangleInView Witness::triangle_in_view(PrimitiveId primitive) const {
    return {first_pixel_, {view_.width, view_.height}, bounds_, corners_of(scene_, std::uint32_t(primitive))};
}

DepthCheck Witness::check(const TriangleDepth& triangle, const Answer& answer, int x, int y) const {
    DepthCheck check{.bound = triangle.at(x, y), .error_over_bound = 0, .lawful = false};
    check.error_over_bound = error_over_bound(check.bound, answer.camera_depth);
    check.lawful = triangle.certainly_holds(check.bound, answer.camera_depth) ||
                   is_lawful_depth(view_, bounds_, corners_of(scene_, std::uint32_t(answer.primitive)),
                                   {x, y}, answer.camera_depth);
    return check;
}

}  // namespace zproof
