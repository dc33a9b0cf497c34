#include <algorithm>
#include <cmath>

#include "scenes/random/kinds.h"

namespace zproof::random {
namespace {

double largest_of(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// A plane whose points of whole numbers float32 holds: they are multiples of 2^-12 of its largest
/// coordinate.
struct ExactPlane {
    glm::dvec3 origin, across, down;

    glm::dvec3 at(int i, int j) const { return origin + double(i) * across + double(j) * down; }
};

ExactPlane exact_plane(Stage& stage) {
    const glm::dvec2 middle(0.5 * stage.view().width, 0.5 * stage.view().height);
    const double depth = stage.depth();
    const glm::dvec3 centre = stage.world({middle, depth});
    const glm::dvec3 right = stage.world({{1.25 * stage.view().width, middle.y}, depth});
    const glm::dvec3 below =
        stage.world({{middle.x, 1.25 * stage.view().height}, stage.depth_about(depth, 0.3)});
    int exponent = 0;
    std::frexp(std::max({largest_of(centre), largest_of(right), largest_of(below)}), &exponent);
    const double step = std::ldexp(1.0, exponent - 12);
    const auto rounded = [&](const glm::dvec3& p) { return step * glm::round(p / step); };
    return {rounded(centre), rounded((right - centre) / 8.0), rounded((below - centre) / 8.0)};
}

/// Two triangles that cross along the line from one place to the other, at an angle that may be small.
void add_crossing_pair(Stage& stage) {
    Random& dice = stage.dice();
    const Place first = stage.place();
    Place second{stage.raster(), stage.depth_about(first.depth, 0.2)};
    const glm::dvec2 half_along = 0.5 * (second.raster - first.raster);
    const glm::dvec2 across(-half_along.y, half_along.x);
    const double lean = dice.binade(-22, -2);
    const auto wing = [&](double side) {
        const Place middle{first.raster + half_along, 0.5 * (first.depth + second.depth)};
        const auto beside = [&](double way) {
            return Place{middle.raster + way * across, middle.depth * (1 + way * side * lean)};
        };
        const Place top{first.raster - half_along, first.depth};
        stage.triangle({top, beside(1), beside(-1)});
    };
    wing(1);
    wing(-1);
}

}  // namespace

void add_coplanar(Stage& stage, int most) {
    stage.mesh().begin_part("coplanar", stage.dice().color());
    ExactPlane plane = exact_plane(stage);
    for (int i = 0; i < most; ++i) {
        if (stage.once_in(16)) plane = exact_plane(stage);
        std::array<glm::dvec3, 3> corners;
        for (glm::dvec3& corner : corners) {
            const int across = stage.dice().integer(-8, 8), down = stage.dice().integer(-8, 8);
            corner = plane.at(across, down);
        }
        stage.triangle(corners);
    }
}

void add_crossing(Stage& stage, int most) {
    stage.mesh().begin_part("crossing", stage.dice().color());
    if (most == 1) return stage.triangle({stage.place(), stage.place(), stage.place()});
    for (int i = 0; i + 1 < most; i += 2) add_crossing_pair(stage);
}

/// Copies of one triangle: its own vertices, vertices of their own, other corners first, or a step of depth
/// behind it.
void add_stacked(Stage& stage, int most) {
    stage.mesh().begin_part("stacked", stage.dice().color());
    Random& dice = stage.dice();
    Corners corners;
    for (Place& corner : corners) corner = stage.place();
    const std::array<std::uint32_t, 3> shared{stage.vertex(corners[0]), stage.vertex(corners[1]),
                                              stage.vertex(corners[2])};
    const double step = dice.integer(0, 2) == 0 ? 0 : dice.binade(-24, -18);
    for (int i = 0; i < most; ++i) {
        const int turn = dice.integer(0, 2);
        const auto turned = [&](int k) { return std::size_t((k + turn) % 3); };
        if (i == 0 || dice.integer(0, 3) == 0) {
            stage.mesh().triangle(shared[turned(0)], shared[turned(1)], shared[turned(2)]);
            continue;
        }
        Corners copy{corners[turned(0)], corners[turned(1)], corners[turned(2)]};
        for (Place& corner : copy) corner.depth *= 1 + step * dice.integer(0, 4);
        stage.triangle(copy);
    }
}

}  // namespace zproof::random
