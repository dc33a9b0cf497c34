/// Footprints and textures by a seed, for tests of texture filters.
#pragma once

#include <cmath>
#include <random>

#include "texture/footprint.h"
#include "texture/linear_image.h"

namespace zproof::texture {

/// The same numbers from any standard library: uniform in [0, 1).
class Rng {
  public:
    explicit Rng(std::uint32_t seed) : engine_{seed} {}
    double uniform() { return double(engine_()) / 0x1p32; }
    double between(double low, double high) { return low + (high - low) * uniform(); }

  private:
    std::mt19937 engine_;
};

/// The footprint with a cone that covers the ellipse of the pixel's own steps, seen square on.
inline Footprint with_cone_of_its_steps(Footprint f) {
    f.cone = {.along = f.per_x / 2.0, .across = f.per_y / 2.0, .cosine = 1};
    return f;
}

/// The footprint at the centre of pixel (0, 0) of a plane that is the same at every pixel: no perspective.
inline Footprint flat_footprint(const glm::dvec2& centre, const glm::dvec2& per_x, const glm::dvec2& per_y) {
    const glm::dvec2 corner = centre - 0.5 * (per_x + per_y);
    return with_cone_of_its_steps(
        footprint({{per_x.x, per_y.x, corner.x}, {per_x.y, per_y.y, corner.y}, {0, 0, 1}}, 0, 0,
                  Derivatives::analytic));
}

/// Of a plane in perspective, anywhere: steps of 2^-3 to 2^7 texels, any turn, anisotropy up to about 100.
inline Footprint random_footprint(std::uint32_t seed) {
    Rng rng{seed};
    const double major = std::exp2(rng.between(-3, 7)), minor = major * std::exp2(-rng.between(0, 6)),
                 texture = rng.between(0, 7), pixel = rng.between(0, 7);
    const glm::dvec2 along{std::cos(texture), std::sin(texture)}, across{-along.y, along.x};
    const glm::dvec2 per_x = major * std::cos(pixel) * along + minor * std::sin(pixel) * across,
                     per_y = -major * std::sin(pixel) * along + minor * std::cos(pixel) * across;
    const glm::dvec2 corner{rng.between(-300, 300), rng.between(-300, 300)};
    return with_cone_of_its_steps(footprint({{per_x.x, per_y.x, corner.x},
                                             {per_x.y, per_y.y, corner.y},
                                             {rng.between(-0.1, 0.1), rng.between(-0.1, 0.1), 1}},
                                            0, 0, Derivatives::analytic));
}

/// Independent channels, uniform in [0, 1), any size.
inline LinearImage random_image(int width, int height, std::uint32_t seed) {
    Rng rng{seed};
    LinearImage image{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        const glm::dvec2 first{rng.uniform(), rng.uniform()}, second{rng.uniform(), rng.uniform()};
        image.texels.emplace_back(glm::vec4{glm::dvec4{first, second}});
    }
    return image;
}

inline LinearImage constant_image(int width, int height, const glm::vec4& value) {
    return {width, height, std::vector<glm::vec4>(std::size_t(width) * std::size_t(height), value)};
}

}  // namespace zproof::texture
