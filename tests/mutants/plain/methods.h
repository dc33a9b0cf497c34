/// The ways to draw.
#pragma once

#include "tests/mutants/plain/depth_code.h"

namespace plain {

/// Float32: corners snap to 1/256 px, edges are integers, triangles are drawn tile by tile.
Picture draw_tiled(const Mesh& mesh, const Camera& camera, DepthBuffer buffer);

/// Float64, and nothing snaps.
Picture draw_unsnapped(const Mesh& mesh, const Camera& camera);

/// Float64, edges before the divide (Olano and Greer 1997), and nothing is clipped.
Picture draw_homogeneous(const Mesh& mesh, const Camera& camera);

/// A ray per pixel through a tree of boxes; float32, Pluecker products.
Picture cast_pluecker(const Mesh& mesh, const Camera& camera);

/// The same in float64, by Moeller and Trumbore (1997).
Picture cast_moeller_trumbore(const Mesh& mesh, const Camera& camera);

}  // namespace plain
