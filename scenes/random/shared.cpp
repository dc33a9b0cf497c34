#include <algorithm>
#include <cmath>
#include <vector>

#include "scenes/random/kinds.h"

namespace zproof::random {
namespace {

/// Columns and rows of quads, two triangles each, that are at most so many.
glm::ivec2 quads_for(Stage& stage, int most) {
    const int quads = std::max(1, most / 2);
    const int across = stage.dice().integer(1, std::max(1, int(std::sqrt(quads))));
    return {across, std::max(1, std::min(quads / across, 16))};
}

/// A quad with either diagonal, wound either way.
void add_quad(Stage& stage, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    if (stage.once_in(2)) std::swap(b, d);
    if (stage.once_in(2))
        stage.mesh().quad({a, b, c, d});
    else
        stage.mesh().quad({b, c, d, a});
}

/// The raster position of a corner of a grid over the image and what is beside it, moved by chance.
glm::dvec2 grid_corner(Stage& stage, const glm::ivec2& at, const glm::ivec2& count, double moved) {
    const glm::dvec2 size(stage.view().width, stage.view().height);
    const double x = stage.dice().uniform(-moved, moved), y = stage.dice().uniform(-moved, moved);
    return size * (1.5 * (glm::dvec2(at) + glm::dvec2(x, y)) / glm::dvec2(count) - 0.25);
}

}  // namespace

void add_surface(Stage& stage, int most) {
    stage.mesh().begin_part("surface", stage.dice().color());
    const glm::ivec2 count = quads_for(stage, most);
    const double depth = stage.depth(), rough = stage.dice().binade(-8, -2);
    const double moved = stage.once_in(3) ? 0 : stage.dice().uniform(0, 0.6);
    std::vector<std::uint32_t> corner;
    for (int y = 0; y <= count.y; ++y)
        for (int x = 0; x <= count.x; ++x) {
            const glm::dvec2 raster = grid_corner(stage, {x, y}, count, moved);
            corner.push_back(stage.vertex({raster, stage.depth_about(depth, rough)}));
        }
    const int row = count.x + 1;
    for (int y = 0; y < count.y; ++y)
        for (int x = 0; x < count.x; ++x) {
            const auto first = std::size_t(y * row + x);
            add_quad(stage, corner[first], corner[first + 1], corner[first + std::size_t(row) + 1],
                     corner[first + std::size_t(row)]);
        }
}

void add_primitives(Stage& stage, int most) {
    Place place = stage.place();
    for (int left = most; left > 0;) {
        stage.mesh().begin_part("primitive " + std::to_string(left), stage.dice().color());
        if (stage.once_in(4)) place = stage.place();
        const int corners = std::min(left, stage.dice().integer(1, 3)) + 2;
        std::vector<std::uint32_t> strip;
        for (int i = 0; i < corners; ++i) {
            const double x = stage.dice().uniform(-6, 6), y = stage.dice().uniform(-6, 6);
            place.raster += glm::dvec2(x, y);
            strip.push_back(stage.vertex({place.raster, stage.depth_about(place.depth, 0.1)}));
        }
        for (std::size_t i = 2; i < strip.size(); ++i)
            stage.mesh().triangle(strip[i - 2], strip[i - 1], strip[i]);
        left -= corners - 2;
    }
}

/// Fans, whose hubs and rims are pixel centres, corners or halves between them.
void add_aligned(Stage& stage, int most) {
    stage.mesh().begin_part("aligned", stage.dice().color());
    Random& dice = stage.dice();
    const auto snapped = [&](const glm::dvec2& raster) {
        const double step = dice.integer(0, 3) == 0 ? 0.25 : 1;
        return step * glm::floor(raster / step) + (dice.integer(0, 2) == 0 ? 0.0 : 0.5);
    };
    const auto exact_depth = [&] {
        const int octave = dice.integer(0, 2);
        return std::ldexp(1 + 0.25 * dice.integer(0, 3), octave);
    };
    for (int left = most; left > 0;) {
        const int spokes = std::min(left, dice.integer(1, 8));
        const double depth = exact_depth();
        const glm::dvec2 centre = stage.raster();
        const std::uint32_t hub = stage.vertex({snapped(centre), depth});
        const double radius = dice.binade(1, 5);
        std::vector<std::uint32_t> rim;
        for (int i = 0; i <= spokes; ++i) {
            const glm::dvec3 away = radius * dice.direction();
            const double own_depth = stage.once_in(4) ? exact_depth() : depth;
            rim.push_back(stage.vertex({snapped(centre + glm::dvec2(away)), own_depth}));
        }
        for (std::size_t i = 1; i < rim.size(); ++i) stage.mesh().triangle(hub, rim[i - 1], rim[i]);
        left -= spokes;
    }
}

}  // namespace zproof::random
