/// The nodes of the scene that is drawn, in depth-first order.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scenes/gltf/model.h"

namespace zproof {

struct PlacedNode {
    int node = 0;                     ///< glTF index
    glm::dmat4 world_from_node{1.0};  ///< composed in double
};

/// The default scene's nodes (or scene 0's, or all roots where the file has no scene), parents before
/// children, children in file order. Throws SceneError for transforms that are not finite or not affine, and
/// where there is no node at all.
std::vector<PlacedNode> placed_nodes(const GltfModel& model);

}  // namespace zproof
