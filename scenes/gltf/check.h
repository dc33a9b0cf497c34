/// What must hold of the structures that tinygltf made of a guarded glTF file, before anything is read by
/// them.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

namespace zproof {

/// Throws SceneError unless accessors lie inside their buffer views, the attributes of a primitive have one
/// length and the types that glTF gives them (integer positions need KHR_mesh_quantization), no node is its
/// own ancestor or beyond limits, scenes list roots, and cameras project. Gives a note on nodes with several
/// parents, which glTF forbids but files have.
std::vector<std::string> check_model(const std::filesystem::path& file, const tinygltf::Model& model);

}  // namespace zproof
