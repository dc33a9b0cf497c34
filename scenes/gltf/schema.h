/// The shape of glTF JSON: types, required properties, enumerations and references.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace zproof {

/// Checks every property that is used. tinygltf ignores a property of a wrong type and cuts integers to 32
/// bits; behind this neither happens. Throws SceneError with the JSON pointer of an offence.
void check_schema(const std::filesystem::path& file, const nlohmann::json& gltf);

/// The array gltf[name], or an empty one where the file has none.
const nlohmann::json& list_of(const nlohmann::json& gltf, const char* name);

}  // namespace zproof
