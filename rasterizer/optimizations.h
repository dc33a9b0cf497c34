/// Optimizations that save a z-buffer work and do not change its picture. As it stands, hierarchical z is on,
/// and what that hides most by, the nearest first. Plain data only: kernels see it (kernel.h).
#pragma once

namespace zproof::rasterizer {

/// Which triangles are drawn.
enum class Facing {
    both,
    front,  ///< counter-clockwise on the screen, glTF's front. Right for closed meshes seen from outside
};

/// What is known of the depths of a block of pixels.
enum class HierarchicalZ {
    blocks,  ///< the farthest of 4 x 4 pixels: a triangle behind that is not scanned there
    none,    ///< every covered pixel is tested by itself
};

enum class FrustumCulling {
    triangles,  ///< each by its own vertices, after they were transformed
    chunks,     ///< runs of triangles by their box first: their vertices are not transformed
};

enum class DrawOrder {
    as_stored,
    front_to_back,  ///< in each tile, triangle by triangle, where hierarchical z is on; every bit is kept
    front_to_back_where_deep,  ///< that where triangles lie over each other so often that it pays
    chunks_front_to_back,  ///< chunk by chunk, by their boxes' nearest depth: of equal depths another may win
};

struct Optimizations {
    Facing facing = Facing::both;
    HierarchicalZ hierarchical_z = HierarchicalZ::blocks;
    FrustumCulling frustum_culling = FrustumCulling::triangles;
    DrawOrder order = DrawOrder::front_to_back_where_deep;
};

}  // namespace zproof::rasterizer
