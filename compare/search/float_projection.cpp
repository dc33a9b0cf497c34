#include "compare/search/float_projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "math/rounding.h"

namespace zproof {

namespace {

/// Corners that are found together.
constexpr std::size_t together = 32;
template <class T>
using Values = std::array<T, together>;

/// What the loop needs, as plain numbers.
struct Lens {
    glm::vec3 eye, right, up, back;
    float shear_x, shear_y, window_left, window_top, px_per_u, px_per_v, least_depth;
    float shear_abs;      ///< of both, twice
    float most_px_per_u;  ///< in any direction
    float offset;         ///< of the window from the middle, in any direction
    float px_of_rounding;
};

/// Left, top, and right and bottom with another sign, as a FloatBox has them.
constexpr std::size_t side_count = 4;
static_assert(sizeof(FloatBox) == side_count * sizeof(float));

/// Of corners that follow each other, x, y and z in turn, to the sides of their boxes. What single precision
/// is off by: with u its unit roundoff and d = corner - eye, each coordinate in camera space by 5u |d|_1; so
/// a quotient a / z by 10u |d|_1 (1 + |a / z|) / z, where that error leaves z more than half, and 2u |a / z|;
/// scale and window are rounded themselves. `units` of each hold them all, and what their sum is rounded by;
/// px_of_rounding and least_reach_px hold what BoxProjection adds.
template <bool perspective>
[[gnu::always_inline]] inline void project(const Lens& lens, const float* p_world, float* sides) {
    constexpr float unlimited_px = std::numeric_limits<float>::infinity(),
                    most_px = std::numeric_limits<float>::max();
    constexpr float units = 16 * float(unit_roundoff_float32), least_reach_px = 0x1p-32F;
    Values<float> left, top, right, bottom;
    for (std::size_t i = 0; i < together; ++i) {
        const float x = p_world[3 * i] - lens.eye.x, y = p_world[3 * i + 1] - lens.eye.y,
                    z = p_world[3 * i + 2] - lens.eye.z;
        const float distance = std::abs(x) + std::abs(y) + std::abs(z);
        const float along = lens.right.x * x + lens.right.y * y + lens.right.z * z;
        const float above = lens.up.x * x + lens.up.y * y + lens.up.z * z;
        const float depth = -(lens.back.x * x + lens.back.y * y + lens.back.z * z);
        const float per_depth = perspective ? 1 / depth : 1;
        const float u = perspective ? along * per_depth : along - lens.shear_x * depth;
        const float v = perspective ? above * per_depth : above - lens.shear_y * depth;
        const float px = (u - lens.window_left) * lens.px_per_u, py = (lens.window_top - v) * lens.px_per_v;
        const float size = std::abs(u) + std::abs(v);
        const float spread = distance * per_depth * (1 + (perspective ? size : lens.shear_abs));
        const float reach = units * (lens.most_px_per_u * (spread + size + lens.offset)) +
                            units * (std::abs(px) + std::abs(py)) + lens.px_of_rounding * distance +
                            least_reach_px;
        // neither a NaN nor what a float cannot hold is a place
        const float farthest = std::abs(px) + std::abs(py) + reach, error = units * distance;
        const bool is_known = (depth - error >= lens.least_depth) & (!perspective | (2 * error <= depth)) &
                              (farthest < most_px);
        left[i] = is_known ? px - reach : -unlimited_px;
        top[i] = is_known ? py - reach : -unlimited_px;
        right[i] = is_known ? -px - reach : -unlimited_px;
        bottom[i] = is_known ? -py - reach : -unlimited_px;
    }
    for (std::size_t i = 0; i < together; ++i) {
        float* const box = sides + side_count * i;
        box[0] = left[i], box[1] = top[i], box[2] = right[i], box[3] = bottom[i];
    }
}

/// Compiled once per instruction set; what it finds does not depend on which runs.
[[gnu::target_clones("default", "avx2", "avx512f")]] void project_perspective(const Lens& lens,
                                                                              const float* p_world,
                                                                              float* sides) {
    project<true>(lens, p_world, sides);
}
[[gnu::target_clones("default", "avx2", "avx512f")]] void project_parallel(const Lens& lens,
                                                                           const float* p_world,
                                                                           float* sides) {
    project<false>(lens, p_world, sides);
}

/// No less than half the near depth, nor than what numbers without denormals can tell.
float least_depth_of(const BoxProjection::Terms& terms) {
    if (!terms.perspective) return -std::numeric_limits<float>::infinity();
    return std::max(float(terms.least_depth * (1 + 2 * unit_roundoff_float32)), 0x1p-100F);
}

Lens lens_of(const BoxProjection::Terms& terms) {
    const Camera& c = terms.camera;
    return {.eye = c.eye_world,
            .right = glm::vec3(c.right),
            .up = glm::vec3(c.up),
            .back = glm::vec3(c.back),
            .shear_x = float(c.shear.x),
            .shear_y = float(c.shear.y),
            .window_left = float(c.window.left),
            .window_top = float(c.window.top),
            .px_per_u = float(terms.px_per_u),
            .px_per_v = float(terms.px_per_v),
            .least_depth = least_depth_of(terms),
            .shear_abs = float(2 * (std::abs(c.shear.x) + std::abs(c.shear.y))),
            .most_px_per_u = float(std::max(terms.px_per_u, terms.px_per_v)),
            .offset = float(std::abs(c.window.left) + std::abs(c.window.top)),
            .px_of_rounding = float(terms.px_of_rounding * (1 + 16 * unit_roundoff_float32))};
}

}  // namespace

void FloatProjection::project(std::span<const glm::vec3> p_world, std::span<FloatBox> boxes) const {
    const Lens lens = lens_of(terms_);
    const auto project = terms_.perspective ? project_perspective : project_parallel;
    std::array<glm::vec3, together> rest{};
    std::array<float, side_count * together> sides;
    for (std::size_t first = 0; first < p_world.size(); first += together) {
        const std::size_t count = std::min(together, p_world.size() - first);
        const glm::vec3* corners = &p_world[first];
        if (count < together) corners = (std::copy_n(corners, count, rest.begin()), rest.data());
        project(lens, &corners->x, sides.data());
        std::memcpy(static_cast<void*>(&boxes[first]), sides.data(), count * sizeof(FloatBox));
    }
}

}  // namespace zproof
