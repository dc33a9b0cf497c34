/// Extensions that compress the data of meshes, by the names that people know them by.
#pragma once

#include <string>
#include <string_view>

namespace zproof {

/// "Draco", "meshopt"; empty for an extension that compresses no mesh.
constexpr std::string_view compressor_of(std::string_view extension) {
    if (extension == "KHR_draco_mesh_compression") return "Draco";
    const bool is_meshopt = extension == "EXT_meshopt_compression" || extension == "KHR_meshopt_compression";
    return is_meshopt ? "meshopt" : "";
}

/// What a refusal says of a mesh that was compressed so.
inline std::string refusal_of_compression(std::string_view extension) {
    return "compressed with " + std::string(compressor_of(extension)) + " (" + std::string(extension) +
           "); zproof does not decode it: export without compression";
}

}  // namespace zproof
