/// A checked glTF file: its structure, its buffers and the images that it needs.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scenes/gltf_files.h"
#include "scenes/scene.h"

namespace zproof {

struct GltfModel {
    std::filesystem::path file;
    tinygltf::Model gltf;  ///< every reference and range in it is checked; without buffers and images
    std::vector<std::span<const unsigned char>> buffers;  ///< by glTF index, as long as declared
    std::map<int, Image> images;  ///< those that base colour textures use, by glTF index
    std::vector<std::string> notes;
    std::vector<std::unique_ptr<const Bytes>> bytes;  ///< what the buffers are views of
};

/// Reads and checks a .gltf or .glb. Throws SceneError (docs/scenes.md).
GltfModel read_gltf(const std::filesystem::path& file);

}  // namespace zproof
