/// What glTF JSON says about itself, checked before anything is read by it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "scenes/gltf_container.h"
#include "scenes/gltf_files.h"

namespace zproof {

/// Extensions: throws SceneError for a required one that the loader does not know; gives a note for those
/// used only.
std::vector<std::string> check_extensions(const std::filesystem::path& file, const nlohmann::json& gltf);

/// Buffers, buffer views and accessors lie inside one another; attributes of a primitive have one length and
/// the types that glTF gives them. Integer positions need KHR_mesh_quantization.
void check_ranges(const std::filesystem::path& file, const nlohmann::json& gltf);

/// There is no cycle, the depth and the number of nodes to draw are bounded, and scenes list roots. Several
/// parents, which glTF forbids but files have, are drawn as instances; gives a note then.
std::vector<std::string> check_nodes(const std::filesystem::path& file, const nlohmann::json& gltf);

/// Every camera projects: fields of view, magnifications and depths are in range.
void check_cameras(const std::filesystem::path& file, const nlohmann::json& gltf);

/// Images that a base colour texture uses: the only ones that are read.
std::set<int> images_in_use(const nlohmann::json& gltf);

/// Admits the files of all buffers and of the images in use, and checks data URIs.
Admitted admit_files(const std::filesystem::path& file, const nlohmann::json& gltf,
                     const Container& container);

}  // namespace zproof
