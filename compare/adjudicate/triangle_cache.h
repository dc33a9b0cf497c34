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
    TriangleCache(const Scene& scene, const View& view, const TriangleSearch& search,
                  std::span<const std::uint32_t> near);

    std::size_t count() const { return near_.size(); }
    std::uint32_t triangle(std::size_t place) const { return near_[place]; }
    /// Nothing for what is not near the tile.
    std::optional<std::size_t> place_of(PrimitiveId answer) const;
    /// The box around the triangle's image, by the bounds of every renderer.
    const Box& widest_box(std::size_t place) const { return boxes_[place].all; }
    /// The box, and the bounds, by one renderer's bounds.
    const Box& box(std::size_t place, const ViewBounds& bounds);
    const BoundedTriangle& of(std::size_t place, const ViewBounds& bounds);

  private:
    struct OfRenderer {
        const ViewBounds* bounds;
        std::vector<std::optional<BoundedTriangle>> triangles;  ///< by place
    };

    const Scene& scene_;
    const Camera& camera_;
    std::span<const std::uint32_t> near_;  ///< ascending
    std::vector<ImageBoxes> boxes_;        ///< by place
    std::vector<OfRenderer> renderers_;    ///< a few
};

}  // namespace zproof
