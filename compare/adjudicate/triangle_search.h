/// Which triangles come near which parts of the image: the judge's own search, independent of any renderer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/adjudicate/corner_hull.h"
#include "compare/adjudicate/tiles.h"
#include "compare/admissible/neighbourhood.h"
#include "math/bulk.h"
#include "scenes/scene.h"

namespace zproof {

/// Lists of triangles, one per tile, each ascending.
struct TrianglesByTile {
    std::vector<std::size_t> first;  ///< by tile, and one more: where its list begins
    Bulk<std::uint32_t> triangles;

    std::span<const std::uint32_t> of(std::size_t tile) const {
        return std::span(triangles).subspan(first[tile], first[tile + 1] - first[tile]);
    }
};

class TriangleSearch {
  public:
    /// Looks at every vertex once; on all threads. Both must outlive it.
    TriangleSearch(const Scene& scene, const View& view);

    /// All triangles whose image (in front of half the near depth) may meet the box that a tile asks for;
    /// `asked` has one for each tile, empty where nothing is asked. Too many is harmless, too few is not:
    /// images are widened by the rounding error of their own computation. On all threads; one pass over the
    /// scene.
    TrianglesByTile find(std::span<const Box> asked) const;
    /// The box around a triangle's image in front of half the near depth; empty where there is none.
    Box box_of(std::uint32_t triangle) const;

  private:
    /// Rounded outwards; unlimited where the vertex lies behind half the near depth or is no place.
    struct VertexBox {
        float left, top, right, bottom;
    };
    struct TileTriangle {
        std::uint32_t tile, triangle;
    };
    Box box_of_vertex(std::uint32_t vertex) const;
    std::optional<CornerHull> hull_of(std::uint32_t triangle) const;
    template <class Visit>
    void for_each_tile_met(std::uint32_t triangle, std::span<const Box> asked, double reach_px,
                           const Visit& visit) const;

    const Scene& scene_;
    BoxProjection projection_;
    Tiles tiles_;
    Bulk<VertexBox> vertices_;
};

/// Fills site.triangles of all sites, in any order: see TriangleSearch::find().
void find_nearby_triangles(const Scene& scene, const View& view, std::span<SearchPixel> search_pixels);

}  // namespace zproof
