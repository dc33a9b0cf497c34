/// Where the corners of a run of triangles lie in the image.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "compare/search/float_projection.h"
#include "math/bulk.h"

namespace zproof {

/// Those of one triangle.
class FloatCorners {
  public:
    FloatCorners(const FloatBox& a, const FloatBox& b, const FloatBox& c) : corners_{a, b, c} {}

    FloatBox all() const {
        FloatBox all = corners_[0];
        all.add(corners_[1]);
        all.add(corners_[2]);
        return all;
    }
    CornerBoxes in_double() const;

  private:
    std::array<FloatBox, 3> corners_;
};

/// Each corner is found once where the run's indices lie close together, as they do in most meshes, and
/// otherwise once for every triangle. Only the run's are kept: those of a whole scene would take half of the
/// scene's own memory.
class RunCorners {
  public:
    RunCorners(std::span<const glm::vec3> p_world, const FloatProjection& projection,
               std::span<const glm::uvec3> run);

    /// Of triangle i of the run, which has these corners.
    FloatCorners of(std::size_t i, const glm::uvec3& t) const {
        const glm::uvec3 at = is_shared_ ? t - first_ : std::uint32_t(3 * i) + glm::uvec3(0, 1, 2);
        return {boxes_[at.x], boxes_[at.y], boxes_[at.z]};
    }

  private:
    bool is_shared_ = false;
    std::uint32_t first_ = 0;
    Bulk<FloatBox> boxes_;
};

}  // namespace zproof
