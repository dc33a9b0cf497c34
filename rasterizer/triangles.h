/// What is drawn: triangles on the sub-pixel grid. Plain data only: kernels see it (kernel.h).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "frame/frame.h"
#include "rasterizer/snap.h"

namespace zproof::rasterizer {

/// A vertex after divide, viewport and snap.
struct SnappedVertex {
    SnappedPoint p;
    double inverse_depth = 0;  ///< of the vertex before it was snapped (DepthFunctional)
};

/// What clipping left of a triangle, or a part of that.
struct SnappedPiece {
    SnappedVertex vertex[3];
    PrimitiveId id = PrimitiveId::none;
};

/// The triangles of a frame by entry: triangle `place` of the scene where entry < length, else piece
/// entry - length.
struct Triangles {
    const SnappedVertex* vertices = nullptr;
    const glm::uvec3* corners = nullptr;
    const SnappedPiece* pieces = nullptr;
    std::uint32_t length = 0;
};

/// Set in an entry: the triangle is counter-clockwise on the screen (y down), so its last two vertices change
/// places.
inline constexpr std::uint32_t turned = 0x8000'0000;

}  // namespace zproof::rasterizer
