/// The triangles that come near a tile, each by the bounds of every renderer that is asked about; made when
/// first asked for.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compare/adjudicate/triangle_search.h"

namespace zproof {

class TriangleCache {
  public:
    /// `near` are those that the search found near the tile.
    TriangleCache(const Scene& scene, const TriangleSearch& search, std::span<const std::uint32_t> near);

    std::size_t count() const { return near_.size(); }
    std::uint32_t triangle(std::size_t place) const { return near_[place]; }
    /// The box around the triangle's image.
    const Box& box(std::size_t place) const { return boxes_[place]; }
    const BoundedTriangle& of(std::size_t place, const ViewBounds& bounds);

  private:
    struct OfRenderer {
        const ViewBounds* bounds;
        std::vector<std::optional<BoundedTriangle>> triangles;  ///< by place
    };

    const Scene& scene_;
    std::span<const std::uint32_t> near_;  ///< ascending
    std::vector<Box> boxes_;               ///< by place
    std::vector<OfRenderer> renderers_;    ///< a few
};

}  // namespace zproof
