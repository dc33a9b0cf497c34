#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "compare/bounds/bounds.h"

namespace zproof {

/// Do both triangles lie in one plane, exactly?
bool coplanar(const CornersWorld& a, const CornersWorld& b);

/// Do three points lie on one line, exactly? True where two of them are the same.
bool collinear(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The direction of a segment, either way round, as one number and the most that it errs by. It is a quotient
/// of two linear forms of the direction, which collinear segments share.
struct Slope {
    double value, error;
};

Slope slope_of(const glm::vec3& a, const glm::vec3& b);

/// Do the segments certainly lie on two lines?
inline bool are_turned(const Slope& a, const Slope& b) {
    return std::abs(a.value - b.value) > a.error + b.error;
}

/// Remembers answers to coplanar(); what it answers never depends on what it remembers. One thread at a time.
class CoplanarCache {
  public:
    /// A triangle, and the id that tells it from all others.
    struct Triangle {
        std::uint32_t id;
        const CornersWorld& p_world;
    };

    /// The cache holds that many pairs; `pairs` is a power of two.
    explicit CoplanarCache(std::size_t pairs) : pairs_(pairs), shift_(64 - int(std::bit_width(pairs - 1))) {}

    bool operator()(const Triangle& a, const Triangle& b) {
        const std::uint64_t pair = std::uint64_t{a.id} << 32 | b.id;
        Pair& place = pairs_[pair * 0x9E3779B97F4A7C15u >> shift_];
        if (place.ids != pair || !place.is_known) place = {pair, true, coplanar(a.p_world, b.p_world)};
        return place.are_coplanar;
    }

  private:
    struct Pair {
        std::uint64_t ids = 0;
        bool is_known = false, are_coplanar = false;
    };
    std::vector<Pair> pairs_;
    int shift_;  ///< of a hash, to a place among them
};

}  // namespace zproof
