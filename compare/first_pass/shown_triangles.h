/// The triangles that a tile of either frame shows, each with both renderers' laws of its depth.
#pragma once

#include <vector>

#include "compare/first_pass/law_maker.h"

namespace zproof {

class ShownTriangles {
  public:
    ShownTriangles(const Scene& scene, const Witness& candidate, const Witness& reference);

    /// Forgets all, for another tile.
    void clear();
    /// Where the laws of a triangle of the scene will stand; never 0, which is the place of law_of_nothing.
    std::uint32_t place_of(PrimitiveId triangle) {
        const std::uint64_t key = key_of(triangle);
        const Slot& first = slots_[first_slot_of(triangle)];
        return first.key == key ? first.place : look_further(triangle);
    }
    /// So many were shown.
    std::size_t count() const { return triangles_.size() - 1; }
    /// By place, from 1 on.
    std::span<const PrimitiveId> triangles() const { return std::span(triangles_).subspan(1); }
    /// Made when first asked for; they move when some are asked for again, after more was shown.
    const LawsOfBoth& laws() {
        if (made_ < triangles_.size()) make_laws();
        return laws_;
    }
    /// By place, in that tile; where nobody stands, tolerances that hold nowhere.
    void set_tolerances(const PixelBox& tile, std::vector<DepthTolerance>& far_off,
                        std::vector<CornerTolerance>& next_to_corners) const;

  private:
    /// Of a table with open addressing; of this tile where its key is one of this tile's.
    struct Slot {
        std::uint64_t key = 0;  ///< the tile's number and the triangle
        std::uint32_t place = 0;
    };
    std::uint64_t key_of(PrimitiveId triangle) const { return tile_ << 32 | std::uint32_t(triangle); }
    std::size_t first_slot_of(PrimitiveId triangle) const {
        return (std::uint32_t(triangle) * 0x9E3779B97F4A7C15u >> 40) & (slots_.size() - 1);
    }
    std::uint32_t look_further(PrimitiveId triangle);
    void grow();
    void make_laws();

    LawMaker maker_;
    std::vector<PrimitiveId> triangles_;  ///< by place
    std::vector<Slot> slots_;
    std::uint64_t tile_ = 0;  ///< its number, from 1 on
    LawsOfBoth laws_;         ///< by place, and what is left of earlier tiles
    std::size_t made_ = 0;    ///< so many are of this one
};

}  // namespace zproof
