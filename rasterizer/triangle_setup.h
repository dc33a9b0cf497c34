/// Triangles on the sub-pixel grid.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "rasterizer/edge_function.h"
#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"

namespace zproof::rasterizer {

using Corners = std::array<SnappedPoint, 3>;

/// Of a triangle that is clockwise on the screen (y down). Edge i lies opposite corner i, so that E_i(p) /
/// (E_0 + E_1 + E_2) is the barycentric weight of corner i at p.
std::array<EdgeFunction, 3> edges_of(const Corners& corners, FillRule rule) noexcept;

/// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    bool is_empty() const { return x0 >= x1 || y0 >= y1; }
};

/// A triangle that may cover samples.
struct Placed {
    Corners corners;           ///< clockwise
    PixelRect pixels;          ///< of the image, those whose samples lie in the triangle's bounding box
    bool was_counter = false;  ///< it was counter-clockwise; its last two corners have changed places
};

/// Both windings are drawn, or the counter-clockwise (setup.facing). Nothing where the snapped area is 0 or
/// no sample of the image is in the bounding box: such a triangle covers no sample.
std::optional<Placed> placed(const Corners& corners, const ViewSetup& setup) noexcept;

/// What is left of a triangle, by the outcodes of its vertices.
enum class Remains { nothing, whole, cut };

/// Nothing, too, of a triangle with a vertex that is not finite.
Remains remains_of(const glm::uvec3& corners, const ProjectedVertices& projected) noexcept;

/// Appends the fan of what clipping leaves of one triangle of the scene. All pieces carry the triangle's id.
void append_pieces(std::vector<SnappedPiece>& out, const Scene& scene, const ViewSetup& setup,
                   std::uint32_t triangle);

}  // namespace zproof::rasterizer
