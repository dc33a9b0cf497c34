/// Triangles on the sub-pixel grid.
#pragma once

#include <array>
#include <vector>

#include "rasterizer/edge_function.h"
#include "rasterizer/triangles.h"
#include "rasterizer/view_setup.h"
#include "scenes/scene.h"

namespace zproof::rasterizer {

using Corners = std::array<SnappedPoint, 3>;

/// The edge functions of a triangle that is clockwise on the screen (y down). Edge i lies opposite corner i,
/// so that E_i(p) / (E_0 + E_1 + E_2) is the barycentric weight of corner i at p.
std::array<EdgeFunction, 3> edges_of(const Corners& corners, FillRule rule) noexcept;

/// What is left of a triangle, by the outcodes of its vertices (clip.h).
enum class ClipOutcome { nothing, whole, cut };

/// A triangle with a vertex that is not finite leaves nothing, too.
inline ClipOutcome clip_outcome(const glm::uvec3& corners, const std::uint8_t* outcodes) noexcept {
    const int a = outcodes[corners.x], b = outcodes[corners.y], c = outcodes[corners.z];
    if ((a | b | c) == 0) return ClipOutcome::whole;
    if ((a | b | c) & outcode::not_finite || (a & b & c & outcode::invisible)) return ClipOutcome::nothing;
    return (a | b | c) & outcode::needs_clip ? ClipOutcome::cut : ClipOutcome::whole;
}

/// Appends the fan of what clipping leaves of one triangle of the scene. All pieces carry the triangle's id.
void append_pieces(std::vector<SnappedPiece>& out, const Scene& scene, const ViewSetup& setup,
                   std::uint32_t triangle);

}  // namespace zproof::rasterizer
