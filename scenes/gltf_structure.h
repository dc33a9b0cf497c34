/// glTF JSON as structures.
#pragma once

#include <tiny_gltf.h>

#include <nlohmann/json.hpp>

namespace zproof {

/// What is baked of a checked glTF JSON, in tinygltf's structures, with glTF's defaults where the JSON is
/// silent: no buffers and no images, whose bytes are not in it. tinygltf's own parser would read the text a
/// second time and copy every buffer.
tinygltf::Model structure_of(const nlohmann::json& gltf);

}  // namespace zproof
