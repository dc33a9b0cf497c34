#include "compare/corner_cells.h"

#include <array>
#include <bit>
#include <cmath>

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
    double last_column, last_row;
};

[[gnu::always_inline]] inline double clamped(double value, double most) {
    const double raised = value > 0 ? value : 0;
    return raised < most ? raised : most;
}

/// Of corners that follow each other, x, y and z in turn, to the four sides of their reaches.
template <bool perspective>
[[gnu::always_inline]] inline void project(const Lens& lens, const float* p_world, std::int16_t* sides) {
    Values<std::int32_t> left, top, right, bottom;
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
        const double reach = lens.px_of_rounding * (std::abs(x) + std::abs(y) + std::abs(z)) +
                             16 * unit_roundoff_float64 * size;
        // a NaN is no place either
        const bool is_known = (depth >= lens.least_depth) & (px_abs + py_abs + reach < unlimited);
        constexpr double per_px = 1.0 / Cells::side_px;
        const double first_column = clamped((px - reach) * per_px, lens.last_column),
                     first_row = clamped((py - reach) * per_px, lens.last_row),
                     last_column = clamped((px + reach) * per_px, lens.last_column),
                     last_row = clamped((py + reach) * per_px, lens.last_row);
        left[i] = std::int32_t(is_known ? first_column : 0);
        top[i] = std::int32_t(is_known ? first_row : 0);
        right[i] = std::int32_t(is_known ? last_column : lens.last_column);
        bottom[i] = std::int32_t(is_known ? last_row : lens.last_row);
    }
    for (std::size_t i = 0; i < together; ++i) {
        sides[4 * i] = std::int16_t(left[i]);
        sides[4 * i + 1] = std::int16_t(top[i]);
        sides[4 * i + 2] = std::int16_t(-right[i]);
        sides[4 * i + 3] = std::int16_t(-bottom[i]);
    }
}

/// Compiled once per instruction set; what it finds does not depend on which runs.
[[gnu::target_clones("default", "avx2", "avx512f")]] void project_perspective(const Lens& lens,
                                                                              const float* p_world,
                                                                              std::int16_t* sides) {
    project<true>(lens, p_world, sides);
}
[[gnu::target_clones("default", "avx2", "avx512f")]] void project_parallel(const Lens& lens,
                                                                           const float* p_world,
                                                                           std::int16_t* sides) {
    project<false>(lens, p_world, sides);
}

}  // namespace

void CornerCells::find(std::span<const glm::vec3> p_world, std::span<CellReach> reach) const {
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
                    .px_of_rounding = terms_.px_of_rounding,
                    .last_column = double(cells_.columns - 1),
                    .last_row = double(cells_.rows - 1)};
    const auto project = terms_.perspective ? project_perspective : project_parallel;
    std::array<glm::vec3, together> rest{};
    std::array<std::int16_t, 4 * together> sides;
    for (std::size_t first = 0; first < p_world.size(); first += together) {
        const std::size_t count = std::min(together, p_world.size() - first);
        const glm::vec3* corners = &p_world[first];
        if (count < together) corners = (std::copy_n(corners, count, rest.begin()), rest.data());
        project(lens, &corners->x, sides.data());
        const auto found = std::bit_cast<std::array<CellReach, together>>(sides);
        std::copy_n(found.begin(), count, &reach[first]);
    }
}

}  // namespace zproof
