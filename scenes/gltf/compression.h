/// glTF whose meshes are compressed: KHR_draco_mesh_compression and EXT_meshopt_compression.
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "scenes/gltf/model.h"

namespace zproof {

/// "Draco", "meshopt"; empty for an extension that compresses no mesh.
std::string_view compressor_of(std::string_view extension);

/// Whether this build decodes what the extension compresses.
bool is_decoded(std::string_view extension);

/// What a refusal says of a mesh that was compressed so, where this build cannot decode it.
std::string refusal_of_compression(std::string_view extension);

/// Buffers that are there to be named only: they have no bytes, since all their views are compressed.
std::set<int> stand_ins(const GltfModel& model);

/// Whether Draco has the triangles of the primitive, and this build decodes them.
bool is_draco_primitive(const gltf::Primitive& primitive);

/// Throws SceneError for compression that contradicts the file.
void check_compression(const GltfModel& model);

/// Decodes into buffers of their own, and has views and primitives name them. The model is checked and has
/// its buffers. Throws SceneError.
void decode_compressed(GltfModel& model);

}  // namespace zproof
