/// Meshes at nodes into world-space triangles.
#pragma once

#include <vector>

#include "scenes/gltf/model.h"
#include "scenes/gltf/nodes.h"
#include "scenes/scene.h"

namespace zproof {

/// Appends every triangle of every placed mesh: nodes in order, primitives in order, triangles in order;
/// strips and fans unrolled in glTF's winding. Positions are transformed in double and rounded once. Vertices
/// are shared within one primitive at one node. Materials must be baked already (the last one is the
/// default). Throws SceneError for indices out of range, positions that overflow float32, and scenes beyond
/// limits.
void bake_meshes(const GltfModel& model, const std::vector<PlacedNode>& nodes, Scene& scene);

}  // namespace zproof
