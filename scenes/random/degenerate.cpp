#include <algorithm>
#include <cmath>

#include "scenes/random/kinds.h"

namespace zproof::random {
namespace {

/// A wall behind everything, so that what is without area must not show before it.
void add_wall(Stage& stage) {
    const glm::dvec2 size(stage.view().width, stage.view().height);
    const Camera& c = stage.view().camera;
    const double depth =
        std::isfinite(c.far_depth) ? c.near_depth + 0.9 * (c.far_depth - c.near_depth) : 1000 * c.near_depth;
    const auto corner = [&](double x, double y) { return stage.vertex({size * glm::dvec2(x, y), depth}); };
    const std::uint32_t a = corner(-0.1, -0.1), b = corner(1.1, -0.1), c3 = corner(1.1, 1.1),
                        d = corner(-0.1, 1.1);
    stage.mesh().quad({a, b, c3, d});
}

void add_flawed(Stage& stage) {
    Random& dice = stage.dice();
    const glm::dvec3 a = stage.world(stage.place()), b = stage.world(stage.place());
    switch (dice.integer(0, 5)) {
        case 0: {
            const std::uint32_t first = stage.mesh().vertex(a), second = stage.mesh().vertex(b);
            return stage.mesh().triangle(first, dice.integer(0, 1) ? first : second, second);
        }
        case 1:
            return stage.triangle(std::array{a, b, a});
        case 2:
            return stage.triangle(std::array{a, a, a});
        case 3:
            return stage.triangle(std::array{a, b, 0.5 * (a + b)});
        case 4: {
            const double along = dice.uniform(-1, 2);
            return stage.triangle(std::array{a, b, a + along * (b - a)});
        }
        default: {
            const glm::dvec3 moved = dice.binade(-30, -8) * (b - a), other = dice.binade(-30, -8) * (a - b);
            return stage.triangle(std::array{a, a + moved, a + other});
        }
    }
}

}  // namespace

/// What has no area has large bounds: a crowd of it takes a judge long.
void add_degenerate(Stage& stage, int most) {
    const int count = std::min(most, 64);
    stage.mesh().begin_part("degenerate", stage.dice().color());
    const bool has_wall = count > 2 && stage.once_in(2);
    if (has_wall) add_wall(stage);
    for (int i = has_wall ? 2 : 0; i < count; ++i) add_flawed(stage);
}

}  // namespace zproof::random
