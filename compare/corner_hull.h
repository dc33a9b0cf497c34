/// What a triangle's image keeps to, by its corners alone.
#pragma once

#include <array>

#include "compare/image_box.h"

namespace zproof {

/// The hull of the boxes that its corners lie in.
class CornerHull {
  public:
    explicit CornerHull(const std::array<Box, 3>& corners);

    /// Does a line along one of the sides part the box from all three corners, certainly?
    bool is_beside(const Box& box) const;

  private:
    /// From the least to the greatest scalar product with a direction.
    struct Range {
        double least, most;
    };
    struct Direction {
        double x, y;

        Range of(const Box& box) const;
    };
    struct Side {
        Direction across;
        Range corners;
    };
    std::array<Side, 3> sides_;
};

}  // namespace zproof
