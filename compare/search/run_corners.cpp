#include "compare/search/run_corners.h"

#include <algorithm>
#include <vector>

namespace zproof {

namespace {

struct IndexRange {
    std::uint32_t first, last;
};
static_assert(sizeof(glm::uvec3) == 3 * sizeof(std::uint32_t));
/// Of the corners of at least one triangle. Compilers make vectors of it.
[[gnu::target_clones("default", "avx2")]] IndexRange index_range(std::span<const glm::uvec3> run) {
    const std::uint32_t* const index = &run[0].x;
    std::uint32_t first = index[0], last = index[0];
    for (std::size_t i = 0; i < 3 * run.size(); ++i) {
        first = index[i] < first ? index[i] : first;
        last = index[i] > last ? index[i] : last;
    }
    return {first, last};
}

}  // namespace

CornerBoxes FloatCorners::in_double() const {
    CornerBoxes boxes;
    for (std::size_t i = 0; i < four_count; ++i) {
        const Box box = corners_[std::min(i, corners_.size() - 1)].in_double();
        boxes.left[i] = box.left, boxes.right[i] = box.right;
        boxes.top[i] = box.top, boxes.bottom[i] = box.bottom;
    }
    return boxes;
}

RunCorners::RunCorners(std::span<const glm::vec3> p_world, const FloatProjection& projection,
                       std::span<const glm::uvec3> run) {
    const auto [first, last] = index_range(run);
    is_shared_ = last - first < 3 * run.size();
    first_ = first;
    std::vector<glm::vec3> apart;
    if (!is_shared_)
        for (const glm::uvec3& t : run) apart.insert(apart.end(), {p_world[t.x], p_world[t.y], p_world[t.z]});
    const auto corners = is_shared_ ? p_world.subspan(first, std::size_t{last} - first + 1) : apart;
    boxes_.resize(corners.size());
    projection.project(corners, boxes_);
}

}  // namespace zproof
