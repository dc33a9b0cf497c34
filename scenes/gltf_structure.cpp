#include "scenes/gltf_structure.h"

#include <string>
#include <utility>
#include <vector>

#include "scenes/gltf_schema.h"

namespace zproof {
namespace {

using nlohmann::json;

/// The member, or what stands for it where the object has none.
template <typename T>
T member(const json& of, const char* name, T otherwise) {
    const auto found = of.find(name);
    return found == of.end() ? std::move(otherwise) : found->get<T>();
}

int index(const json& of, const char* name) { return member(of, name, -1); }

/// One structure for each element of gltf[name].
template <typename T>
std::vector<T> each(const json& gltf, const char* name, T (*structure)(const json&)) {
    const json& list = list_of(gltf, name);
    std::vector<T> structures;
    structures.reserve(list.size());
    for (const json& element : list) structures.push_back(structure(element));
    return structures;
}

/// Numbers, texts and what is made of them; members that are null are left out.
tinygltf::Value value(const json& from) {
    if (from.is_number_integer()) return tinygltf::Value(from.get<int>());
    if (from.is_number()) return tinygltf::Value(from.get<double>());
    if (from.is_boolean()) return tinygltf::Value(from.get<bool>());
    if (from.is_string()) return tinygltf::Value(from.get<std::string>());
    tinygltf::Value::Array array;
    tinygltf::Value::Object object;
    for (const auto& [name, element] : from.items())
        if (!element.is_null())
            from.is_array() ? array.push_back(value(element)) : void(object.emplace(name, value(element)));
    return from.is_array() ? tinygltf::Value(std::move(array)) : tinygltf::Value(std::move(object));
}

/// Only those that are objects, as glTF has them.
tinygltf::ExtensionMap extensions(const json& of) {
    tinygltf::ExtensionMap extensions;
    if (const auto found = of.find("extensions"); found != of.end() && found->is_object())
        for (const auto& [name, extension] : found->items())
            if (extension.is_object()) extensions.emplace(name, value(extension));
    return extensions;
}

int type_of(const std::string& name) {
    constexpr std::pair<const char*, int> types[] = {
        {"SCALAR", TINYGLTF_TYPE_SCALAR}, {"VEC2", TINYGLTF_TYPE_VEC2}, {"VEC3", TINYGLTF_TYPE_VEC3},
        {"VEC4", TINYGLTF_TYPE_VEC4},     {"MAT2", TINYGLTF_TYPE_MAT2}, {"MAT3", TINYGLTF_TYPE_MAT3},
        {"MAT4", TINYGLTF_TYPE_MAT4}};
    for (const auto& [known, type] : types)
        if (name == known) return type;
    return -1;
}

tinygltf::BufferView buffer_view(const json& from) {
    tinygltf::BufferView view;
    view.buffer = from["buffer"];
    view.byteOffset = member(from, "byteOffset", std::size_t{0});
    view.byteLength = from["byteLength"];
    view.byteStride = member(from, "byteStride", std::size_t{0});
    return view;
}

void add_sparse(const json& from, tinygltf::Accessor& accessor) {
    const json &indices = from["indices"], &values = from["values"];
    auto& sparse = accessor.sparse;
    sparse.isSparse = true;
    sparse.count = from["count"];
    sparse.indices.bufferView = indices["bufferView"];
    sparse.indices.byteOffset = member(indices, "byteOffset", 0);
    sparse.indices.componentType = indices["componentType"];
    sparse.values.bufferView = values["bufferView"];
    sparse.values.byteOffset = member(values, "byteOffset", 0);
}

tinygltf::Accessor accessor(const json& from) {
    tinygltf::Accessor accessor;
    accessor.bufferView = index(from, "bufferView");
    accessor.byteOffset = member(from, "byteOffset", std::size_t{0});
    accessor.normalized = member(from, "normalized", false);
    accessor.componentType = from["componentType"];
    accessor.count = from["count"];
    accessor.type = type_of(from["type"].get_ref<const std::string&>());
    accessor.sparse.isSparse = false;
    if (const auto sparse = from.find("sparse"); sparse != from.end()) add_sparse(*sparse, accessor);
    return accessor;
}

tinygltf::Primitive primitive(const json& from) {
    tinygltf::Primitive primitive;
    for (const auto& [name, accessor] : from["attributes"].items())
        primitive.attributes.emplace(name, accessor.get<int>());
    primitive.indices = index(from, "indices");
    primitive.material = index(from, "material");
    primitive.mode = member(from, "mode", TINYGLTF_MODE_TRIANGLES);
    primitive.targets.resize(list_of(from, "targets").size());
    return primitive;
}

tinygltf::Mesh mesh(const json& from) {
    tinygltf::Mesh mesh;
    mesh.name = member(from, "name", std::string());
    mesh.primitives = each(from, "primitives", primitive);
    return mesh;
}

tinygltf::Node node(const json& from) {
    using Numbers = std::vector<double>;
    tinygltf::Node node;
    node.name = member(from, "name", std::string());
    node.children = member(from, "children", std::vector<int>());
    node.mesh = index(from, "mesh");
    node.camera = index(from, "camera");
    node.skin = index(from, "skin");
    node.matrix = member(from, "matrix", Numbers());
    node.translation = member(from, "translation", Numbers());
    node.rotation = member(from, "rotation", Numbers());
    node.scale = member(from, "scale", Numbers());
    node.extensions = extensions(from);
    return node;
}

tinygltf::Scene scene(const json& from) {
    tinygltf::Scene scene;
    scene.nodes = member(from, "nodes", std::vector<int>());
    return scene;
}

tinygltf::Material material(const json& from) {
    tinygltf::Material material;
    material.name = member(from, "name", std::string());
    const auto found = from.find("pbrMetallicRoughness");
    if (found == from.end()) return material;
    tinygltf::PbrMetallicRoughness& surface = material.pbrMetallicRoughness;
    surface.baseColorFactor = member(*found, "baseColorFactor", surface.baseColorFactor);
    if (const auto use = found->find("baseColorTexture"); use != found->end()) {
        surface.baseColorTexture.index = (*use)["index"];
        surface.baseColorTexture.texCoord = member(*use, "texCoord", 0);
        surface.baseColorTexture.extensions = extensions(*use);
    }
    return material;
}

tinygltf::Texture texture(const json& from) {
    tinygltf::Texture texture;
    texture.sampler = index(from, "sampler");
    texture.source = index(from, "source");
    return texture;
}

tinygltf::Sampler sampler(const json& from) {
    tinygltf::Sampler sampler;
    sampler.minFilter = index(from, "minFilter");
    sampler.magFilter = index(from, "magFilter");
    sampler.wrapS = member(from, "wrapS", TINYGLTF_TEXTURE_WRAP_REPEAT);
    sampler.wrapT = member(from, "wrapT", TINYGLTF_TEXTURE_WRAP_REPEAT);
    return sampler;
}

/// Numbers that the JSON leaves out are 0, which glTF does not allow them to be.
tinygltf::Camera camera(const json& from) {
    tinygltf::Camera camera;
    camera.type = from["type"];
    camera.name = member(from, "name", std::string());
    const json& intrinsics = from[camera.type];
    if (camera.type == "perspective") {
        camera.perspective.aspectRatio = member(intrinsics, "aspectRatio", 0.0);
        camera.perspective.yfov = intrinsics["yfov"];
        camera.perspective.zfar = member(intrinsics, "zfar", 0.0);
        camera.perspective.znear = intrinsics["znear"];
    } else {
        camera.orthographic.xmag = intrinsics["xmag"];
        camera.orthographic.ymag = intrinsics["ymag"];
        camera.orthographic.zfar = intrinsics["zfar"];
        camera.orthographic.znear = intrinsics["znear"];
    }
    return camera;
}

}  // namespace

tinygltf::Model structure_of(const json& gltf) {
    tinygltf::Model model;
    model.bufferViews = each(gltf, "bufferViews", buffer_view);
    model.accessors = each(gltf, "accessors", accessor);
    model.meshes = each(gltf, "meshes", mesh);
    model.nodes = each(gltf, "nodes", node);
    model.scenes = each(gltf, "scenes", scene);
    model.defaultScene = index(gltf, "scene");
    model.materials = each(gltf, "materials", material);
    model.textures = each(gltf, "textures", texture);
    model.samplers = each(gltf, "samplers", sampler);
    model.cameras = each(gltf, "cameras", camera);
    model.animations.resize(list_of(gltf, "animations").size());
    return model;
}

}  // namespace zproof
