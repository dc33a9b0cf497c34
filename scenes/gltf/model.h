/// A checked glTF file: its structure, its buffers and the images that it needs.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace zproof {

struct GltfModel {
    std::filesystem::path file;
    tinygltf::Model gltf;         ///< every reference and range in it is checked
    std::map<int, Image> images;  ///< those that base colour textures use, by glTF index
    std::vector<std::string> notes;
};

/// Reads and checks a .gltf or .glb. Throws SceneError (docs/scenes.md).
GltfModel read_gltf(const std::filesystem::path& file);

}  // namespace zproof
