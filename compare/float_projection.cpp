#include "compare/float_projection.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
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
    glm::dvec3 eye, right, up, back;
    double shear_x, shear_y, window_left, window_top, px_per_u, px_per_v, least_depth, px_of_rounding;
};

/// Left, top, and right and bottom with another sign, as a FloatBox has them.
constexpr std::size_t side_count = 4;
static_assert(sizeof(FloatBox) == side_count * sizeof(float));

/// Of corners that follow each other, x, y and z in turn, to the sides of their boxes.
template <bool perspective>
[[gnu::always_inline]] inline void project(const Lens& lens, const float* p_world, float* sides) {
    constexpr float unlimited_px = std::numeric_limits<float>::infinity(),
                    most_px = std::numeric_limits<float>::max();
    Values<float> left, top, right, bottom;
    for (std::size_t i = 0; i < together; ++i) {
        const double x = double(p_world[3 * i]) - lens.eye.x, y = double(p_world[3 * i + 1]) - lens.eye.y,
                     z = double(p_world[3 * i + 2]) - lens.eye.z;
        const double along = lens.right.x * x + lens.right.y * y + lens.right.z * z;
        const double above = lens.up.x * x + lens.up.y * y + lens.up.z * z;
        const double depth = -(lens.back.x * x + lens.back.y * y + lens.back.z * z);
        const double u = perspective ? along / depth : along - lens.shear_x * depth;
        const double v = perspective ? above / depth : above - lens.shear_y * depth;
        const double px = (u - lens.window_left) * lens.px_per_u, py = (lens.window_top - v) * lens.px_per_v;
        const double px_abs = std::abs(px), py_abs = std::abs(py);
        const double larger = px_abs < py_abs ? py_abs : px_abs, size = larger < 65536 ? 65536 : larger;
        const double in_double = lens.px_of_rounding * (std::abs(x) + std::abs(y) + std::abs(z)) +
                                 16 * unit_roundoff_float64 * size;
        const double reach = in_double + 2 * unit_roundoff_float32 * (larger + in_double);
        // neither a NaN nor what a float cannot hold is a place
        const bool is_known = (depth >= lens.least_depth) & (px_abs + py_abs + reach < most_px);
        left[i] = is_known ? float(px - reach) : -unlimited_px;
        top[i] = is_known ? float(py - reach) : -unlimited_px;
        right[i] = is_known ? float(-px - reach) : -unlimited_px;
        bottom[i] = is_known ? float(-py - reach) : -unlimited_px;
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

}  // namespace

void FloatProjection::project(std::span<const glm::vec3> p_world, std::span<FloatBox> boxes) const {
    const Camera& c = terms_.camera;
    const Lens lens{.eye = glm::dvec3(c.eye_world),
                    .right = c.right,
                    .up = c.up,
                    .back = c.back,
                    .shear_x = c.shear.x,
                    .shear_y = c.shear.y,
                    .window_left = c.window.left,
                    .window_top = c.window.top,
                    .px_per_u = terms_.px_per_u,
                    .px_per_v = terms_.px_per_v,
                    .least_depth = terms_.least_depth,
                    .px_of_rounding = terms_.px_of_rounding};
    const auto project = terms_.perspective ? project_perspective : project_parallel;
    std::array<glm::vec3, together> rest{};
    std::array<float, side_count * together> sides;
    for (std::size_t first = 0; first < p_world.size(); first += together) {
        const std::size_t count = std::min(together, p_world.size() - first);
        const glm::vec3* corners = &p_world[first];
        if (count < together) corners = (std::copy_n(corners, count, rest.begin()), rest.data());
        project(lens, &corners->x, sides.data());
        const auto found = std::bit_cast<std::array<FloatBox, together>>(sides);
        std::copy_n(found.begin(), count, &boxes[first]);
    }
}

}  // namespace zproof
