/// What must hold of a glTF file before anything is read by it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/gltf/model.h"

namespace zproof {

/// Checks types, required properties, enumerations and references of all that is used. Throws SceneError with
/// the JSON pointer of an offence.
void check_schema(const std::filesystem::path& file, const nlohmann::json& gltf);

/// Throws SceneError for an unknown extension that is required, and unless buffer views lie inside their
/// buffers and accessors inside their buffer views, data URIs and the BIN chunk hold what buffers declare,
/// the attributes of a primitive have one length and the types that glTF gives them (integer positions need
/// KHR_mesh_quantization), no node is its own ancestor or beyond limits, scenes list roots, and cameras
/// project. The JSON has passed check_schema(). Gives notes on what is ignored or against glTF's rules.
std::vector<std::string> check_model(const GltfModel& model);

}  // namespace zproof
