/// glTF whose meshes are compressed: KHR_draco_mesh_compression and EXT_meshopt_compression.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/gltf/container.h"
#include "scenes/gltf/meshopt.h"

namespace zproof {

/// "Draco", "meshopt"; empty for an extension that compresses no mesh.
std::string_view compressor_of(std::string_view extension);

/// Whether this build decodes what the extension compresses.
bool is_decoded(std::string_view extension);

/// What a refusal says of a mesh that was compressed so, where this build cannot decode it.
std::string refusal_of_compression(std::string_view extension);

/// Buffers that are there to be named only: they have no bytes, since all their views are compressed.
std::set<std::size_t> stand_ins(const nlohmann::json& gltf, const Container& container);

/// Whether Draco has the triangles of the primitive, and this build decodes them.
bool is_draco_primitive(const nlohmann::json& primitive);

/// Throws SceneError for compression that contradicts the file. The JSON keeps the schema.
void check_compression(const std::filesystem::path& file, const nlohmann::json& gltf,
                       const Container& container);

/// A primitive whose triangles Draco has.
struct DracoPrimitive {
    std::size_t mesh = 0, primitive = 0, view = 0;
    int indices = -1;                          ///< the accessor, or none
    std::map<std::string, std::uint32_t> ids;  ///< in the stream, by the attribute's name
};

struct CompressedMeshes {
    std::map<std::size_t, MeshoptView> views;  ///< by the buffer view that they fill
    std::vector<DracoPrimitive> primitives;

    bool empty() const { return views.empty() && primitives.empty(); }
};

/// Says what is compressed, and takes out of the JSON what tinygltf refuses of it: buffers without bytes and
/// index accessors without a buffer view.
CompressedMeshes take_out_compressed(nlohmann::json& gltf, const Container& container);

/// Gives the primitives their index accessors back.
void put_indices_back(const CompressedMeshes& compressed, tinygltf::Model& model);

/// Decodes into buffers of their own, and has views and primitives name them. The model is checked. Throws
/// SceneError.
void decode_compressed(const std::filesystem::path& file, const CompressedMeshes& compressed,
                       tinygltf::Model& model);

}  // namespace zproof
