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

/// The boxes around a triangle's image; empty where there is none.
struct ImageBoxes {
    Box all;               ///< by the bounds of every renderer
    Box beyond_half_near;  ///< by the bounds of one whose near plane is never off by half the near depth

    bool are_one() const { return all == beyond_half_near; }
    /// By a renderer's bounds.
    const Box& by(const TriangleBounds& bounds, const Camera& camera) const {
        return bounds.near_slack < camera.near_depth / 2 ? beyond_half_near : all;
    }
};

/// By whose bounds triangles are asked about.
using Renderers = std::span<const ViewBounds* const>;

/// Looks at what lies beyond half the near depth. Where a renderer's `near_slack` of a triangle is larger, it
/// looks at all that the triangle has before the eye.
class TriangleSearch {
  public:
    /// Looks at every vertex and triangle once; on all threads. The scene must outlive it.
    TriangleSearch(const Scene& scene, const View& view, Renderers renderers);

    /// All triangles whose image may meet the box that a tile asks for;
    /// `asked` has one for each tile, empty where nothing is asked. Too many is harmless, too few is not:
    /// images are widened by the rounding error of their own computation. On all threads; one pass over the
    /// scene.
    TrianglesByTile find(std::span<const Box> asked) const;
    /// The box around a triangle's image; empty where there is none.
    Box box_of(std::uint32_t triangle) const { return boxes_of(triangle).all; }
    ImageBoxes boxes_of(std::uint32_t triangle) const;

  private:
    /// Rounded outwards; unlimited where the vertex lies nearer than half the near depth or is no place.
    struct VertexBox {
        float left, top, right, bottom;
    };
    struct TileTriangle {
        std::uint32_t tile, triangle;
    };
    struct NearTriangle {
        std::uint32_t triangle;
        ImageBoxes boxes;
    };
    void find_near_triangles(const View& view, Renderers renderers);
    Box box_of_vertex(std::uint32_t vertex) const;
    std::optional<CornerHull> hull_of(std::uint32_t triangle) const;
    template <class Visit>
    void for_each_tile_met(std::uint32_t triangle, std::span<const Box> asked, double reach_px,
                           const Visit& visit) const;

    const Scene& scene_;
    BoxProjection projection_;
    Tiles tiles_;
    Bulk<VertexBox> vertices_;
    std::vector<NearTriangle> near_;  ///< with an image and a corner of unlimited box; ascending
};

/// Fills site.triangles of all sites, in any order: see TriangleSearch::find().
void find_nearby_triangles(const Scene& scene, const View& view, Renderers renderers,
                           std::span<SearchPixel> search_pixels);

}  // namespace zproof
