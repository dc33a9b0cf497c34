/// The images of a glTF file.
#pragma once

#include "scenes/gltf/model.h"
#include "scenes/scene_files.h"

namespace zproof {

/// Reads the images that base colour textures use, into model.images; the model has its structure and its
/// buffers. Several are decoded side by side. Throws SceneError, naming the first in glTF order that is
/// broken or beyond limits; notes images whose type is not the one declared, and how many were not read.
void read_images(Admission& admission, GltfModel& model);

}  // namespace zproof
