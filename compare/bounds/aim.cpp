#include "compare/bounds/aim.h"

#include <array>

namespace zproof {

Aim::Aim(const ViewFacts& facts, double direction_error, double origin_error, double offset_px) {
    const Camera& c = facts.view.camera;
    const std::array axes{c.right, c.up, c.back};
    const glm::dvec3 origin_world = glm::abs(glm::dvec3(c.eye_world)) + facts.origin_abs;
    glm::dvec3 direction, origin;  // errors per camera axis
    for (int i = 0; i < 3; ++i) {
        direction[i] = direction_error * glm::dot(glm::abs(axes[std::size_t(i)]), facts.direction_abs);
        origin[i] =
            facts.perspective ? 0 : origin_error * glm::dot(glm::abs(axes[std::size_t(i)]), origin_world);
    }
    px = offset_px + facts.scale.lateral_px(facts.perspective ? direction : origin);
    start = facts.start;
    px_per_depth = facts.perspective ? 0 : facts.scale.lateral_px(direction);
    depth_relative = direction.z;
    depth_absolute = origin.z;
}

}  // namespace zproof
