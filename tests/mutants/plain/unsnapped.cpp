#include <algorithm>

#include "tests/mutants/plain/assembly.h"
#include "tests/mutants/plain/methods.h"
#include "tests/mutants/plain/target.h"

namespace plain {
namespace {

using Corner = RasterVertex<double>;

/// Above 0 right of the edge from a to b, y down. Turned round it is the exact negative.
double edge_function(const Corner& a, const Corner& b, double x, double y) {
    if (b.y < a.y || (b.y == a.y && b.x < a.x)) return -edge_function(b, a, x, y);
    return (y - a.y) * (b.x - a.x) - (x - a.x) * (b.y - a.y);
}

/// Top-left rule, for a point exactly on the edge.
bool owns(const Corner& a, const Corner& b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

bool is_inside(double e, const Corner& a, const Corner& b) { return e > 0 || (e == 0 && owns(a, b)); }

void draw_triangle(const Corner& a, const Corner& b, const Corner& c, std::uint32_t id, Target& target,
                   const Camera& camera) {
    const double area = edge_function(a, b, c.x, c.y);
    if (area < 0) return draw_triangle(a, c, b, id, target, camera);
    if (!(area > 0)) return;
    const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
    const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
    const int x_last = std::min(camera.width - 1, int(x_high)),
              y_last = std::min(camera.height - 1, int(y_high));
    for (int y = std::max(0, int(y_low)); y <= y_last; ++y)
        for (int x = std::max(0, int(x_low)); x <= x_last; ++x) {
            const double of_a = edge_function(b, c, x + 0.5, y + 0.5);
            const double of_b = edge_function(c, a, x + 0.5, y + 0.5);
            const double of_c = edge_function(a, b, x + 0.5, y + 0.5);
            if (is_inside(of_a, b, c) && is_inside(of_b, c, a) && is_inside(of_c, a, b))
                target.draw(x, y, float((of_a / area * a.z + of_b / area * b.z) + of_c / area * c.z), id);
        }
}

}  // namespace

Picture draw_unsnapped(const Mesh& mesh, const Camera& camera) {
    Target target(camera, DepthBuffer::camera_depth);
    assemble<double>(mesh, camera, DepthBuffer::camera_depth,
                     [&](const Corner& a, const Corner& b, const Corner& c, std::uint32_t id) {
                         draw_triangle(a, b, c, id, target, camera);
                     });
    return target.finished();
}

}  // namespace plain
