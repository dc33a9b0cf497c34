/// The depths of the triangles that a part of the image shows, by both renderers' bounds.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/bounds/triangle_depth.h"
#include "compare/rendered_frame.h"

namespace zproof {

/// A place for each triangle, made when it is first looked up. One thread at a time.
class BoundTable {
  public:
    explicit BoundTable(const FramePair& frames)
        : frames_(frames), first_pixel_(frames.view, 0, 0), slots_(least_slots) {}

    struct Depths {
        TriangleDepth candidate, reference;
    };

    /// Forgets all triangles.
    void clear();
    /// The place of a triangle of the scene.
    std::uint32_t place_of(PrimitiveId triangle);
    /// Makes the depths of all triangles that were looked up.
    void make();
    const Depths& operator[](std::uint32_t place) const { return depths_[place]; }

  private:
    struct Slot {
        PrimitiveId triangle = PrimitiveId::none;
        std::uint32_t place = 0;
    };
    Slot& slot_of(PrimitiveId triangle);
    void grow();

    static constexpr std::size_t least_slots = 1024;
    const FramePair& frames_;
    ViewRay<double> first_pixel_;
    std::vector<PrimitiveId> triangles_;  ///< by place
    std::vector<Slot> slots_;             ///< open addressing; a power of two
    std::vector<Depths> depths_;          ///< by place
};

}  // namespace zproof
