#include <algorithm>
#include <cstdlib>

#include "measure/instruments.h"
#include "measure/probe.h"

namespace zproof::measure {
namespace {

constexpr int cell_size = 16;  ///< px; holds the triangle of any direction
constexpr int cells_in_row = 4;

/// Directions of edges: level, upright, diagonal, and one within each octant.
std::vector<glm::ivec2> directions() {
    std::vector<glm::ivec2> all;
    for (int dx = -2; dx <= 2; ++dx) {
        for (int dy = -2; dy <= 2; ++dy) {
            const int longer = std::max(std::abs(dx), std::abs(dy)),
                      shorter = std::min(std::abs(dx), std::abs(dy));
            if (longer == 1 || (longer == 2 && shorter == 1)) all.push_back({dx, dy});
        }
    }
    return all;
}

}  // namespace

FillSides fill_sides(const Renderer& renderer, const Sample& sample) {
    const std::vector<glm::ivec2> all = directions();
    Scene scene;
    const auto watched = [](std::size_t i) {
        return glm::ivec2{cell_size * int(i % cells_in_row) + cell_size / 2,
                          cell_size * int(i / cells_in_row) + cell_size / 2};
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::dvec2 centre = glm::dvec2(watched(i)) + glm::dvec2{sample.x, sample.y}, d{all[i]};
        const glm::dvec2 right{-d.y, d.x};  // y down
        const glm::dvec2 from = centre - 2.0 * d, to = centre + 2.0 * d, inside = centre + 2.0 * right;
        add_triangle(scene, Axis::x, {{{from.x, from.y}, {to.x, to.y}, {inside.x, inside.y}}});
    }
    const Frame frame =
        renderer.render(scene, raster_view(cell_size * cells_in_row, cell_size * cells_in_row));
    FillSides sides;
    for (std::size_t i = 0; i < all.size(); ++i)
        sides.push_back({all[i].x, all[i].y, is_covered(frame, Axis::x, watched(i).x, watched(i).y)});
    return sides;
}

}  // namespace zproof::measure
