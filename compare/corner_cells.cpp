#include "compare/corner_cells.h"

#include <cmath>

#include "math/rounding.h"

namespace zproof {

namespace {

/// Corners that are found together.
constexpr std::size_t together = 32;
template <class T>
using Values = std::array<T, together>;

struct FromEye {
    Values<double> x, y, z;  ///< less the eye's
};
struct Reaches {
    Values<std::int32_t> left, top, right, bottom;
};

/// What the loop needs, as plain numbers.
struct Lens {
    glm::dvec3 right, up, back;
    double shear_x, shear_y, window_left, window_top, px_per_u, px_per_v, least_depth, px_of_rounding;
    double last_column, last_row;
};

[[gnu::always_inline]] inline double clamped(double value, double most) {
    const double raised = value > 0 ? value : 0;
    return raised < most ? raised : most;
}

template <bool perspective>
[[gnu::always_inline]] inline void project(const Lens& lens, const FromEye& from_eye, Reaches& reaches) {
    for (std::size_t i = 0; i < together; ++i) {
        const double x = from_eye.x[i], y = from_eye.y[i], z = from_eye.z[i];
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
        const double left = clamped((px - reach) * per_px, lens.last_column),
                     top = clamped((py - reach) * per_px, lens.last_row),
                     right = clamped((px + reach) * per_px, lens.last_column),
                     bottom = clamped((py + reach) * per_px, lens.last_row);
        reaches.left[i] = std::int32_t(is_known ? left : 0);
        reaches.top[i] = std::int32_t(is_known ? top : 0);
        reaches.right[i] = std::int32_t(is_known ? right : lens.last_column);
        reaches.bottom[i] = std::int32_t(is_known ? bottom : lens.last_row);
    }
}

/// Compiled once per instruction set; what it finds does not depend on which runs.
[[gnu::target_clones("default", "avx2", "avx512f")]] void project_perspective(const Lens lens,
                                                                              const FromEye& from_eye,
                                                                              Reaches& reaches) {
    project<true>(lens, from_eye, reaches);
}
[[gnu::target_clones("default", "avx2", "avx512f")]] void project_parallel(const Lens lens,
                                                                           const FromEye& from_eye,
                                                                           Reaches& reaches) {
    project<false>(lens, from_eye, reaches);
}

}  // namespace

void CornerCells::find(std::span<const glm::vec3> p_world, std::span<CellReach> reach) const {
    const Camera& c = terms_.camera;
    const glm::dvec3 eye(c.eye_world);
    const Lens lens{.right = c.right,
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
    FromEye from_eye{};
    Reaches found;
    for (std::size_t first = 0; first < p_world.size(); first += together) {
        const std::size_t count = std::min(together, p_world.size() - first);
        for (std::size_t i = 0; i < count; ++i) {
            const glm::vec3& p = p_world[first + i];
            from_eye.x[i] = double(p.x) - eye.x;
            from_eye.y[i] = double(p.y) - eye.y;
            from_eye.z[i] = double(p.z) - eye.z;
        }
        (terms_.perspective ? project_perspective : project_parallel)(lens, from_eye, found);
        for (std::size_t i = 0; i < count; ++i)
            reach[first + i] = {found.left[i], found.top[i], found.right[i], found.bottom[i]};
    }
}

}  // namespace zproof
