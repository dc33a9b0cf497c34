/// Edge functions without error: places are integers of 2^-20 px.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "scenes/view.h"
#include "tests/attack/limit_renderer.h"

namespace zproof::attack {

inline constexpr std::int64_t fixed_one = 1 << 20;  ///< a pixel

/// In steps; farther than farthest_place_px by less than a pixel.
struct FixedPoint {
    std::int64_t x = 0, y = 0;
};
using FixedTriangle = std::array<FixedPoint, 3>;

/// Where a pixel is sampled; exact, since samples are multiples of 1/256 px.
FixedPoint fixed_sample(const View& view, int x, int y);

/// Pixels from left up to, and not including, right.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};

class FixedEdges {
  public:
    FixedEdges(const FixedTriangle& triangle, EdgeOwner owner);

    /// Those whose samples it may hold, and a pixel more.
    PixelBox box(const View& view) const;
    /// The corners' shares of a place that it holds; none where it does not hold it, or has no area.
    std::optional<std::array<double, 3>> weights_at(const FixedPoint& p) const;

  private:
    FixedTriangle corners_;  ///< so that inside is on the left
    bool is_turned_ = false;
    EdgeOwner owner_;
};

}  // namespace zproof::attack
