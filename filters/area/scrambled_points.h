/// Points in the unit square for estimates with a confidence interval: Sobol's sequence in two dimensions
/// under Owen's nested uniform scrambling, several times independently.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "math/mixed.h"

namespace zproof::oracle::area {

/// Component 0 or 1 of point `index` of Sobol's sequence, as a fraction of 2^32.
std::uint32_t sobol(int component, std::uint32_t index);

/// Owen's scrambling (1995): each bit is flipped or not by a coin that depends on the bits above it. Bits
/// below the first sixteen are taken at random together.
std::uint32_t scrambled(std::uint32_t fraction, std::uint64_t seed);

/// Independent replicates of the first points, made once; each pixel flips all bits of a replicate by words
/// of its own (a digital shift), which leaves a scrambled net a scrambled net.
class ScrambledPoints {
  public:
    static constexpr int replicates = 16, most_points = 1024;

    ScrambledPoints();

    /// The shift of one replicate at one pixel.
    static glm::u32vec2 shift(int x, int y, int replicate);
    /// The point in [0, 1)^2, 32 bits each.
    glm::dvec2 at(int replicate, int index, const glm::u32vec2& shift) const {
        const glm::u32vec2 p = points_[std::size_t(replicate) * most_points + std::size_t(index)];
        return {(p.x ^ shift.x) * 0x1p-32, (p.y ^ shift.y) * 0x1p-32};
    }

  private:
    std::vector<glm::u32vec2> points_;
};

}  // namespace zproof::oracle::area
