/// Triangles of the scene to triangles on the sub-pixel grid.
#pragma once

#include <array>
#include <vector>

#include "frame/frame.h"
#include "rasterizer/edge_function.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {

/// A triangle ready to be scanned: clockwise on the screen (y down), area not 0, all of it drawable.
struct SnappedTriangle {
    std::array<SnappedVertex, 3> vertex;
    PrimitiveId id = PrimitiveId::none;
};

/// Edge i lies opposite vertex i, so that E_i(p) / (E_0 + E_1 + E_2) is the barycentric weight of vertex i at
/// p.
std::array<EdgeFunction, 3> edges_of(const SnappedTriangle& triangle, FillRule rule) noexcept;

/// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool is_empty() const { return x0 >= x1 || y0 >= y1; }
};

/// The pixels of the image whose samples lie in the triangle's bounding box.
PixelRect pixels_within(const SnappedTriangle& triangle, const ViewSetup& setup) noexcept;

/// Appends what is left of one triangle of the scene: nothing, itself, or the fan of its clipped polygon.
/// Both windings are drawn; a triangle whose snapped area is 0 covers no sample and is left out, as is one
/// with a vertex that is not finite. All pieces carry the triangle's id.
void append_snapped(std::vector<SnappedTriangle>& out, const Scene& scene, const ProjectedVertices& projected,
                    const ViewSetup& setup, std::uint32_t triangle);

}  // namespace zproof::rasterizer
