/// Meshes that fill an image with one layer of triangles: every pixel must get exactly one fragment.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <iosfwd>
#include <random>

#include "rasterizer/rules.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

struct Front {
    Scene scene;
    View view;
};

/// Spokes from the centre of pixel (hub, hub) to every pixel centre on a square of half-side `reach` around
/// it: every edge runs through pixel centres, in slopes of all octants.
Front fan_through_centres(int hub, int reach);

/// A lattice of pixel centres spanned by u and v, not parallel: all edges are u, v or u - v.
Front sheared_grid(glm::ivec2 u, glm::ivec2 v);

enum class Direction { across, down };

/// A strip of slivers as long as the image is high (across) or wide (down), from far below a grid step to a
/// few pixels thin; some ends coincide, some lie on pixel centres.
Front slivers(std::mt19937& random, Direction direction);

/// A fan whose rim lies 10^2 to 10^7 px away, mostly beyond the guard band.
Front far_fan(std::mt19937& random);

/// A triangulated box of half-side 10^-2 to 10^4 around the eye, seen in perspective: triangles run through
/// the near plane, past the eye and beyond the guard band.
Front box_from_inside(std::mt19937& random);

/// What is wrong with a front: pixels without a fragment, and fragments too many.
struct Flaws {
    std::uint64_t holes = 0, double_hits = 0;
    bool operator==(const Flaws&) const = default;
};
void PrintTo(const Flaws& flaws, std::ostream* out);  ///< for GoogleTest

Flaws flaws_of(const Front& front, const Rules& rules = correct_rules);

}  // namespace zproof::rasterizer
