/// Surroundings of a pixel from a seed, with the hard cases made likely.
#pragma once

#include <random>

#include "compare/admissible/neighbourhood.h"
#include "scenes/scene.h"

namespace zproof {

/// Numbers that every standard library draws alike.
class Rng {
  public:
    explicit Rng(std::uint32_t seed) : engine_(seed) {}
    int below(int count) { return int(engine_() % std::uint32_t(count)); }
    double between(double low, double high) {
        return low + (high - low) * (std::uint32_t(engine_()) * 0x1p-32);
    }

  private:
    std::mt19937 engine_;
};

/// A view turned at random (perspective, off-axis, parallel or oblique) or, half of the time, a plain one in
/// which one unit is one pixel. Up to 16 x 16 pixels.
View random_view(Rng& rng);

/// The same, parallel and around the origin, but the eye far to the side: its window begins as far to the
/// other.
View view_from_far_away(Rng& rng);

/// A few triangles that crowd around one pixel. Some share edges or corners with others, lie in one plane
/// with another, are slivers, pass through the pixel's centre by a corner or an edge, cross near or far, have
/// a corner on the eye's plane, stand nearly edge-on, or reach 1e30 far.
Scene random_crowd(Rng& rng, const View& view, int x, int y);

/// Everything around the pixel: all of the scene's triangles are neighbours. `extra_eps_px` widens the square
/// beyond what the bounds ask for.
Neighbourhood surroundings(const Scene& scene, const View& view, const ViewBounds& bounds,
                           const PixelCoord& place, double least_eps_px);

/// What a seed stands for.
struct Surroundings {
    View view;
    Scene scene;
    int x = 0, y = 0;
    Neighbourhood around;
};
Surroundings random_surroundings(std::uint32_t seed);

/// Walls that cover the image by far, in planes that nearly agree: some in one plane, some crossing within
/// the square around pixel (1, 1) or beside it, some far behind, some beside the pixel.
Scene random_walls(Rng& rng, const View& view);

}  // namespace zproof
