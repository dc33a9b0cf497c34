/// What a triangle's image keeps to, by its corners alone.
#pragma once

#include "compare/search/image_box.h"

namespace zproof {

/// The hull of the boxes that its corners lie in.
class alignas(four_alignment) CornerHull {
  public:
    CornerHull() {}  ///< of nothing yet
    explicit CornerHull(const CornerBoxes& corners) { draw(corners); }

    /// Where it stands: gcc 12 does not align what a function returns to be assigned.
    void draw(const CornerBoxes& corners);

    /// Does a line along one of the sides part the box from all three corners, certainly?
    bool is_beside(const Box& box) const;

  private:
    /// From the least to the greatest scalar product with each direction.
    struct Range {
        Four least, most;
    };
    Range across(const Box& box) const;

    Four x_, y_;  ///< a direction across each side; the last lane repeats the third
    Range corners_;
};

}  // namespace zproof
