/// What the first pass works out of depths in passing, written down.
#pragma once

#include "compare/first_pass/error_map.h"
#include "compare/first_pass/held_depths.h"
#include "compare/memory.h"
#include "compare/strips/strip.h"
#include "compare/witness.h"

namespace zproof {

/// Writes one renderer's error_over_bound(), strip by strip. One thread at a time.
class ErrorScribe {
  public:
    /// Pixels beyond the first `triangle_count` ids ask nothing. `map` has the view's size.
    ErrorScribe(const Witness& witness, std::size_t triangle_count, Plane<float>& map);

    /// A row's pixels from (x, y) on, at most a strip's.
    struct Pixels {
        int x, y;
        std::size_t count;
    };
    /// Ratios of a strip whose first pixels those are.
    void write(const Strip::Side& shown, const Strip::Values<double>& ratio, const Pixels& pixels);

  private:
    /// By itself: double precision does not hold the depth lawful for certain.
    float error_at(PrimitiveId primitive, int x, int y);

    const Witness& witness_;
    std::uint32_t triangle_count_;
    Plane<float>& map_;
    Memory<std::uint32_t, TriangleDepth> triangles_;
};

}  // namespace zproof
