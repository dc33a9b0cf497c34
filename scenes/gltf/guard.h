/// What must hold before tinygltf reads a glTF file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/gltf/container.h"
#include "scenes/scene_files.h"

namespace zproof {

struct Guarded {
    std::vector<AdmittedFile>
        buffers;  ///< those in files of their own, in the order in which tinygltf asks for them
    std::vector<std::string> notes;  ///< extensions that are ignored
};

/// Throws SceneError for JSON that tinygltf would misread, read beyond a buffer for, or refuse without saying
/// where, and for an unknown extension that is required.
Guarded guarded(const std::filesystem::path& file, const nlohmann::json& gltf, const Container& container,
                Admission& admission);

}  // namespace zproof
