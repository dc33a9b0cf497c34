/// What a glTF file says, as far as it is used. Members have glTF's own names; numbers that glTF defines are
/// tinygltf's TINYGLTF_ constants; -1 is an index to nothing.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.h"
#include "scenes/scene_files.h"

namespace zproof::gltf {

struct Buffer {
    std::size_t byteLength = 0;
    std::string uri;
    nlohmann::json extensions;
    Bytes own;                             ///< from a file or a data URI
    std::span<const unsigned char> chunk;  ///< of a GLB

    std::span<const unsigned char> data() const { return chunk.empty() ? std::span(own) : chunk; }
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Buffer, byteLength, uri, extensions)

struct BufferView {
    int buffer = -1;
    std::size_t byteOffset = 0, byteLength = 0, byteStride = 0;
    nlohmann::json extensions;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(BufferView, buffer, byteOffset, byteLength, byteStride,
                                                extensions)

/// Where a part of a sparse accessor lies.
struct SparsePart {
    int bufferView = -1, componentType = 0;
    std::size_t byteOffset = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(SparsePart, bufferView, componentType, byteOffset)

struct Sparse {
    std::size_t count = 0;  ///< 0: the accessor is not sparse
    SparsePart indices, values;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Sparse, count, indices, values)

struct Accessor {
    int bufferView = -1, componentType = 0;
    std::size_t byteOffset = 0, count = 0;
    bool normalized = false;
    std::string type;
    std::vector<double> min, max;
    Sparse sparse;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Accessor, bufferView, componentType, byteOffset, count,
                                                normalized, type, min, max, sparse)

struct Primitive {
    std::map<std::string, int> attributes;
    int indices = -1, material = -1, mode = TINYGLTF_MODE_TRIANGLES;
    std::vector<std::map<std::string, int>> targets;
    nlohmann::json extensions;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Primitive, attributes, indices, material, mode, targets,
                                                extensions)

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
    std::vector<double> weights;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Mesh, name, primitives, weights)

struct Node {
    std::string name;
    std::vector<int> children;
    int mesh = -1, camera = -1, skin = -1;
    std::vector<double> matrix, translation, rotation, scale;
    std::vector<double> weights;  ///< go before the mesh's
    nlohmann::json extensions;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Node, name, children, mesh, camera, skin, matrix, translation,
                                                rotation, scale, weights, extensions)

struct Scene {
    std::vector<int> nodes;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Scene, nodes)

struct TextureTransform {
    std::vector<double> offset{0, 0}, scale{1, 1};
    double rotation = 0;
    int texCoord = -1;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TextureTransform, offset, scale, rotation, texCoord)

struct TextureInfo {
    int index = -1, texCoord = 0;
    nlohmann::json extensions;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TextureInfo, index, texCoord, extensions)

struct MetallicRoughness {
    std::vector<double> baseColorFactor{1, 1, 1, 1};
    TextureInfo baseColorTexture;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(MetallicRoughness, baseColorFactor, baseColorTexture)

struct Material {
    std::string name;
    MetallicRoughness pbrMetallicRoughness;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Material, name, pbrMetallicRoughness)

struct Texture {
    int sampler = -1, source = -1;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Texture, sampler, source)

struct Sampler {
    int magFilter = -1, minFilter = -1, wrapS = TINYGLTF_TEXTURE_WRAP_REPEAT,
        wrapT = TINYGLTF_TEXTURE_WRAP_REPEAT;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Sampler, magFilter, minFilter, wrapS, wrapT)

struct Image {
    std::string name, uri, mimeType;
    int bufferView = -1;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Image, name, uri, mimeType, bufferView)

/// aspectRatio and zfar are 0 where the file does not state them.
struct Perspective {
    double yfov = 0, aspectRatio = 0, znear = 0, zfar = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Perspective, yfov, aspectRatio, znear, zfar)

struct Orthographic {
    double xmag = 0, ymag = 0, znear = 0, zfar = 0;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Orthographic, xmag, ymag, znear, zfar)

struct Camera {
    std::string name, type;
    Perspective perspective;
    Orthographic orthographic;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Camera, name, type, perspective, orthographic)

struct Document {
    std::vector<Buffer> buffers;
    std::vector<BufferView> bufferViews;
    std::vector<Accessor> accessors;
    std::vector<Mesh> meshes;
    std::vector<Node> nodes;
    std::vector<Scene> scenes;
    int scene = -1;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Sampler> samplers;
    std::vector<Image> images;
    std::vector<Camera> cameras;
    std::vector<std::string> extensionsUsed, extensionsRequired;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Document, buffers, bufferViews, accessors, meshes, nodes,
                                                scenes, scene, materials, textures, samplers, images, cameras,
                                                extensionsUsed, extensionsRequired)

}  // namespace zproof::gltf

namespace zproof {

/// A checked glTF file: its structure, its buffers and the images that it needs.
struct GltfModel {
    std::filesystem::path file;
    gltf::Document document;      ///< every reference and range in it is checked
    std::map<int, Image> images;  ///< those that base colour textures use, by glTF index
    std::vector<std::string> notes;
    std::size_t animations = 0;
    Bytes bytes;                           ///< the file's own
    std::span<const unsigned char> chunk;  ///< the BIN chunk among them; data() is null where there is none
};

/// The element of a list that an index names.
auto& at(auto& list, int index) { return list[static_cast<std::size_t>(index)]; }

/// Components of an element of glTF's type, such as 3 of "VEC3".
int component_count(std::string_view type);

/// What a data URI holds that tinygltf::IsDataURI() knows.
struct DecodedUri {
    Bytes bytes;
    std::string type;  ///< an image's MIME type, where it is stated
};
DecodedUri decoded_uri(const std::string& uri);

/// Reads and checks a .gltf or .glb. Throws SceneError (docs/scenes.md).
GltfModel read_gltf(const std::filesystem::path& file);

}  // namespace zproof
