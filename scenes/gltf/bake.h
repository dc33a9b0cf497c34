/// The steps from a checked model to a scene and its views.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scenes/gltf/model.h"
#include "scenes/loaded.h"

namespace zproof {

/// Reads the images that base colour textures use, into model.images; the model has its structure and its
/// buffers. Several are decoded side by side. Throws SceneError, naming the first in glTF order that is
/// broken or beyond limits; notes images whose type is not the one declared, and how many were not read.
void read_images(Admission& admission, GltfModel& model);

/// Appends the model's materials, in order, and then one default material (white) for primitives without any.
/// Moves the images in use out of the model; Texture::image counts those only. Nothing is baked of a material
/// but its base colour's factor and texture.
void bake_materials(GltfModel& model, Scene& scene);

struct PlacedNode {
    int node = 0;                     ///< glTF index
    glm::dmat4 world_from_node{1.0};  ///< composed in double
};

/// The default scene's nodes (or scene 0's, or all roots where the file has no scene), parents before
/// children, children in file order. Throws SceneError for transforms that are not finite or not affine, and
/// where there is no node at all.
std::vector<PlacedNode> placed_nodes(const GltfModel& model);

/// Appends every triangle of every placed mesh: nodes in order, primitives in order, triangles in order;
/// strips and fans unrolled in glTF's winding. Positions are transformed in double and rounded once. Vertices
/// are shared within one primitive at one node. Materials must be baked already (the last one is the
/// default). Throws SceneError for indices out of range, positions that overflow float32, and scenes beyond
/// limits.
void bake_meshes(const GltfModel& model, const std::vector<PlacedNode>& nodes, Scene& scene);

/// Appends one view per placed camera, named after its node, of `size` pixels; notes go to the scene. The
/// vertical extent is the camera's, the horizontal one follows from the image's aspect.
void bake_cameras(const GltfModel& model, const std::vector<PlacedNode>& nodes, const glm::ivec2& size,
                  Loaded& loaded);

}  // namespace zproof
