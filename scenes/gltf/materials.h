/// Materials: base colour factor and texture; nothing else of a material is baked.
#pragma once

#include "scenes/gltf/model.h"
#include "scenes/scene.h"

namespace zproof {

/// Appends the model's materials, in order, and then one default material (white) for primitives without any.
/// Moves the images in use out of the model; Texture::image counts those only.
void bake_materials(GltfModel& model, Scene& scene);

/// A texture whose uv set no primitive has is dropped, with a note: afterwards uv_set < uv.size() for every
/// texture.
void drop_textures_without_uv(Scene& scene);

}  // namespace zproof
