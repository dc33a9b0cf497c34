/// The triangles that a tile of either frame shows, each with both renderers' laws of its depth.
#pragma once

#include <vector>

#include "compare/law_maker.h"

namespace zproof {

class ShownTriangles {
  public:
    ShownTriangles(const Scene& scene, const Witness& candidate, const Witness& reference);

    /// Forgets all, for another tile.
    void clear();
    /// Where the laws of a triangle of the scene will stand; never 0, which is the place of law_of_nothing.
    std::uint32_t place_of(PrimitiveId triangle);
    /// Makes the laws of what was shown since.
    void make_laws();

    /// So many were shown.
    std::size_t count() const { return triangles_.size() - 1; }
    const LawsOfBoth& laws() const { return laws_; }

  private:
    /// Of a table with open addressing; of this tile where its tile is the present one.
    struct Slot {
        std::uint32_t triangle = 0, place = 0;
        std::uint64_t tile = 0;
    };
    void grow();

    LawMaker maker_;
    std::vector<PrimitiveId> triangles_;  ///< by place
    std::vector<Slot> slots_;
    std::uint64_t tile_ = 1;
    LawsOfBoth laws_;       ///< by place, and what is left of earlier tiles
    std::size_t made_ = 0;  ///< so many are of this one
};

}  // namespace zproof
