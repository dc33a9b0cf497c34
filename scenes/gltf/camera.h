/// glTF's cameras as views.
#pragma once

#include <vector>

#include "scenes/gltf/model.h"
#include "scenes/gltf/nodes.h"
#include "scenes/loaded.h"

namespace zproof {

/// Appends one view per placed camera, named after its node, of  pixels; notes go to the scene.
/// The vertical extent is the camera's, the horizontal one follows from the image's aspect.
void bake_cameras(const GltfModel& model, const std::vector<PlacedNode>& nodes, const glm::ivec2& size,
                  Loaded& loaded);

/// The text with every character that a view's name may not have replaced by '_'; never empty, at most 64
/// long.
std::string view_name(const std::string& text);

}  // namespace zproof
