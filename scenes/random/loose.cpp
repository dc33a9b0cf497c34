#include <algorithm>
#include <cmath>

#include "scenes/random/kinds.h"

namespace zproof::random {
namespace {

/// A place beside another, so many pixels away at most in either direction.
Place beside(Stage& stage, const Place& place, double pixels, double share_of_depth) {
    Random& dice = stage.dice();
    const double x = dice.uniform(-pixels, pixels), y = dice.uniform(-pixels, pixels);
    return {place.raster + glm::dvec2(x, y), stage.depth_about(place.depth, share_of_depth)};
}

void add_patch(Stage& stage, const Place& first, double pixels, double share_of_depth) {
    const Place second = beside(stage, first, pixels, share_of_depth);
    stage.triangle({first, second, beside(stage, first, pixels, share_of_depth)});
}

/// Nearer than near, also behind the eye; farther than far; just on either; or the depth that is there. A far
/// plane beyond 2^(2 octaves) times near is left alone.
double depth_outside(Stage& stage, int octaves, double depth) {
    Random& dice = stage.dice();
    const Camera& c = stage.view().camera;
    const bool is_parallel = c.projection == Projection::parallel;
    const bool has_far = is_parallel || c.far_depth <= std::ldexp(c.near_depth, 2 * octaves);
    const double span = has_far ? c.far_depth - c.near_depth : c.near_depth;
    const double beyond = span * dice.uniform(0, 2);
    switch (dice.integer(0, 5)) {
        case 0:
            return c.near_depth - beyond;
        case 1:
            return has_far ? c.far_depth + beyond : depth;
        case 2:
            return c.near_depth;
        case 3:
            return has_far ? c.far_depth : depth;
        default:
            return depth;
    }
}

/// A corner that is outside of one to three of the view's planes, or just on near or far; beside the image by
/// up to 2^octaves of its size.
Place outside(Stage& stage, int octaves) {
    Random& dice = stage.dice();
    Place place = stage.place();
    const double away = dice.binade(0, octaves - 1);
    if (stage.once_in(2)) place.raster.x += stage.view().width * (dice.integer(0, 1) ? away : -away);
    if (stage.once_in(2)) place.raster.y += stage.view().height * (dice.integer(0, 1) ? away : -away);
    place.depth = depth_outside(stage, octaves, place.depth);
    return place;
}

}  // namespace

void add_soup(Stage& stage, int most) {
    stage.mesh().begin_part("soup", stage.dice().color());
    for (int i = 0; i < most; ++i) {
        const Place first = stage.place();
        const double pixels = stage.dice().binade(-1, 6);
        add_patch(stage, first, pixels, stage.once_in(2) ? 0.05 : 1);
    }
}

void add_slivers(Stage& stage, int most) {
    stage.mesh().begin_part("slivers", stage.dice().color());
    for (int i = 0; i < most; ++i) {
        Random& dice = stage.dice();
        const Place first = stage.place();
        const Place second = beside(stage, first, dice.binade(1, 7), 0.2);
        const double along = dice.uniform(-0.5, 1.5);
        Place third{first.raster + along * (second.raster - first.raster),
                    first.depth + along * (second.depth - first.depth)};
        stage.triangle({first, second, beside(stage, third, dice.binade(-12, -1), 0)});
    }
}

/// Those that are long in depth are seen edge-on, and float32 knows little of them: only few are.
void add_tiny(Stage& stage, int most) {
    stage.mesh().begin_part("tiny", stage.dice().color());
    const double share_of_depth = most <= 8 ? 0.5 : 0x1p-12;
    for (int i = 0; i < most; ++i) {
        Place first = stage.place();
        if (stage.once_in(2)) first.raster = glm::floor(first.raster) + 0.5;
        const double share = stage.once_in(2) ? 0 : share_of_depth;
        add_patch(stage, first, stage.dice().binade(-8, 0), share);
    }
}

/// Edges of far corners are known to few pixels in float32, so that large crowds take a judge long.
void add_clipped(Stage& stage, int most) {
    stage.mesh().begin_part("clipped", stage.dice().color());
    const int count = std::min(most, 64), octaves = count <= 8 ? 12 : 3;
    for (int i = 0; i < count; ++i) {
        Corners corners;
        const int inside = stage.dice().integer(0, 3);
        for (int k = 0; k < 3; ++k)
            corners[std::size_t(k)] = k == inside ? stage.place() : outside(stage, octaves);
        stage.triangle(corners);
    }
}

}  // namespace zproof::random
