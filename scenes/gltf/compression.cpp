#include "scenes/gltf/compression.h"

#include <array>
#include <cstring>
#include <span>
#include <utility>

#include "scenes/gltf/accessor.h"
#include "scenes/gltf/draco.h"
#include "scenes/gltf/schema.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

constexpr const char* draco_extension = "KHR_draco_mesh_compression";
constexpr std::array meshopt_extensions{"EXT_meshopt_compression", "KHR_meshopt_compression"};

const json* extension_of(const json& object, const char* name) {
    const json& extensions = list_of(object, "extensions");
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &*found;
}

const json* meshopt_of(const json& object) {
    if (!has_meshopt()) return nullptr;
    for (const char* name : meshopt_extensions)
        if (const json* found = extension_of(object, name)) return found;
    return nullptr;
}

const json* draco_of(const json& primitive) {
    return has_draco() ? extension_of(primitive, draco_extension) : nullptr;
}

MeshoptView meshopt_view(const json& extension) {
    return {extension["buffer"],
            extension.value("byteOffset", std::size_t{0}),
            extension["byteLength"],
            extension["byteStride"],
            extension["count"],
            extension["mode"],
            extension.value("filter", "NONE")};
}

std::string place_of(const DracoPrimitive& draco) {
    return pointer("meshes", draco.mesh, pointer("primitives", draco.primitive));
}

void check_meshopt(const Path& file, const json& gltf, const std::set<std::size_t>& without_bytes,
                   std::size_t i) {
    const json& declared = gltf["bufferViews"][i];
    const json* extension = meshopt_of(declared);
    const std::string place = pointer("bufferViews", i);
    if (extension == nullptr) {
        if (without_bytes.contains(declared["buffer"].get<std::size_t>()))
            refuse(file, place, "its buffer has no bytes and it is not compressed; export the file again");
        return;
    }
    const MeshoptView view = meshopt_view(*extension);
    if (std::string fault = fault_of(view); !fault.empty())
        refuse(file, place, "meshopt: " + fault + "; export the file again");
    if (view.stride * view.count != declared["byteLength"].get<std::uint64_t>())
        refuse(file, place,
               "meshopt: byteStride x count is " + std::to_string(view.stride * view.count) +
                   ", expected the view's byteLength; export the file again");
    const std::uint64_t there = without_bytes.contains(view.buffer)
                                    ? 0
                                    : gltf["buffers"][view.buffer]["byteLength"].get<std::uint64_t>();
    if (view.offset + view.bytes > there)
        refuse(file, place,
               "meshopt: needs " + std::to_string(view.bytes) + " bytes at " + std::to_string(view.offset) +
                   ", its buffer has " + std::to_string(there) + "; export the file again");
}

void check_draco(const Path& file, const json& primitive, const std::string& place) {
    const json* extension = draco_of(primitive);
    if (extension == nullptr) return;
    if (primitive.value("mode", TINYGLTF_MODE_TRIANGLES) != TINYGLTF_MODE_TRIANGLES)
        refuse(file, place, "compressed with Draco; expected mode 4, triangles: export without compression");
    for (const auto& [name, id] : (*extension)["attributes"].items())
        if (!primitive["attributes"].contains(name))
            refuse(file, place,
                   "Draco has " + name + "; expected it in attributes too: export the file again");
}

/// Attributes that are baked; no others are decoded.
bool is_baked(std::string_view attribute) {
    return attribute == "POSITION" || attribute == "NORMAL" || attribute == "COLOR_0" ||
           attribute.starts_with("TEXCOORD_");
}

DracoPrimitive draco_primitive(std::size_t mesh, std::size_t index, const json& primitive,
                               const json& extension) {
    DracoPrimitive draco{mesh, index, extension["bufferView"], primitive.value("indices", -1), {}};
    for (const auto& [name, id] : extension["attributes"].items())
        if (is_baked(name)) draco.ids.emplace(name, id.get<std::uint32_t>());
    return draco;
}

template <typename T>
std::vector<unsigned char> bytes_of(const std::vector<T>& values) {
    std::vector<unsigned char> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Decodes what is compressed, within a limit for all together.
class Decompression {
  public:
    Decompression(const Path& file, tinygltf::Model& model) : file_(file), model_(model) {}

    void fill(std::size_t index, const MeshoptView& meshopt) {
        const std::string place = pointer("bufferViews", index);
        allow(place, meshopt.stride * meshopt.count);
        std::vector<unsigned char> bytes(meshopt.stride * meshopt.count);
        const std::span<const unsigned char> source = model_.buffers[meshopt.buffer].data;
        if (!decode_meshopt(meshopt, source.subspan(meshopt.offset, meshopt.bytes), bytes))
            refuse(file_, place, "meshopt cannot decode its " + meshopt.mode + "; export the file again");
        tinygltf::BufferView& view = model_.bufferViews[index];
        view.buffer = add_buffer(std::move(bytes));
        view.byteOffset = 0;
    }

    void fill(const DracoPrimitive& draco) {
        const tinygltf::BufferView& view = model_.bufferViews[draco.view];
        const std::span<const unsigned char> stream =
            std::span<const unsigned char>(model_.buffers[static_cast<std::size_t>(view.buffer)].data)
                .subspan(view.byteOffset, view.byteLength);
        const DracoMesh expected = expected_of(draco);
        const std::uint64_t triangles = draco_triangles(stream).value_or(0);
        std::uint64_t vertex_bytes = 0;
        for (const DracoAttribute& each : expected.attributes)
            vertex_bytes +=
                static_cast<std::uint64_t>(each.components) * component_bytes(each.component_type);
        allow(place_of(draco), 12 * triangles + vertex_bytes * expected.vertices);
        DecodedDraco decoded = decode_draco(stream, expected);
        if (!decoded.fault.empty()) refuse(file_, place_of(draco), decoded.fault + "; export the file again");
        put(draco, std::move(decoded));
    }

  private:
    tinygltf::Primitive& primitive_of(const DracoPrimitive& draco) const {
        return model_.meshes[draco.mesh].primitives[draco.primitive];
    }

    const tinygltf::Accessor& accessor(int index) const {
        return model_.accessors[static_cast<std::size_t>(index)];
    }

    void allow(const std::string& place, std::uint64_t bytes) {
        decoded_bytes_ += bytes;
        if (decoded_bytes_ > limits::decoded_bytes)
            refuse(file_, place,
                   "compressed meshes need more than " + std::to_string(limits::decoded_bytes) +
                       " bytes decoded; split the scene");
    }

    int add_buffer(std::vector<unsigned char> bytes) {
        model_.buffers.emplace_back().data = std::move(bytes);
        return static_cast<int>(model_.buffers.size()) - 1;
    }

    /// The accessor over bytes of its own.
    int add_accessor(tinygltf::Accessor accessor, std::vector<unsigned char> bytes) {
        tinygltf::BufferView view;
        view.byteLength = bytes.size();
        view.buffer = add_buffer(std::move(bytes));
        model_.bufferViews.push_back(std::move(view));
        accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
        accessor.byteOffset = 0;
        model_.accessors.push_back(std::move(accessor));
        return static_cast<int>(model_.accessors.size()) - 1;
    }

    DracoMesh expected_of(const DracoPrimitive& draco) const {
        const tinygltf::Primitive& primitive = primitive_of(draco);
        DracoMesh mesh;
        if (primitive.indices >= 0) mesh.corners = accessor(primitive.indices).count;
        for (const auto& [name, id] : draco.ids) {
            const tinygltf::Accessor& declared = accessor(primitive.attributes.at(name));
            mesh.vertices = declared.count;
            mesh.attributes.push_back(
                {id, declared.componentType,
                 tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(declared.type))});
        }
        return mesh;
    }

    /// Accessors are copied: other primitives may name the same ones over other data.
    void put(const DracoPrimitive& draco, DecodedDraco decoded) {
        tinygltf::Primitive& primitive = primitive_of(draco);
        std::size_t i = 0;
        for (const auto& [name, id] : draco.ids) {
            int& index = primitive.attributes.at(name);
            index = add_accessor(tinygltf::Accessor(accessor(index)), std::move(decoded.attributes[i++]));
        }
        tinygltf::Accessor indices;
        indices.sparse = {};  // whose numbers tinygltf leaves unset
        indices.type = TINYGLTF_TYPE_SCALAR;
        indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        indices.count = decoded.indices.size();
        primitive.indices = add_accessor(std::move(indices), bytes_of(decoded.indices));
    }

    const Path& file_;
    tinygltf::Model& model_;
    std::uint64_t decoded_bytes_ = 0;
};

}  // namespace

std::string_view compressor_of(std::string_view extension) {
    if (extension == draco_extension) return "Draco";
    for (const char* name : meshopt_extensions)
        if (extension == name) return "meshopt";
    return "";
}

bool is_decoded(std::string_view extension) {
    const std::string_view compressor = compressor_of(extension);
    return (compressor == "Draco" && has_draco()) || (compressor == "meshopt" && has_meshopt());
}

std::string refusal_of_compression(std::string_view extension) {
    return "compressed with " + std::string(compressor_of(extension)) + " (" + std::string(extension) +
           "); this build of zproof does not decode it: export without compression";
}

std::set<std::size_t> stand_ins(const json& gltf, const Container& container) {
    const json& buffers = list_of(gltf, "buffers");
    std::vector<int> plain(buffers.size()), compressed(buffers.size());
    for (const json& view : list_of(gltf, "bufferViews"))
        ++(meshopt_of(view) == nullptr ? plain : compressed)[view["buffer"].get<std::size_t>()];
    std::set<std::size_t> found;
    for (std::size_t i = container.bin.data() == nullptr ? 0 : 1; i < buffers.size(); ++i) {
        const bool is_named_only = plain[i] == 0 && compressed[i] > 0;
        if (!buffers[i].contains("uri") && (meshopt_of(buffers[i]) != nullptr || is_named_only))
            found.insert(i);
    }
    return found;
}

bool is_draco_primitive(const json& primitive) { return draco_of(primitive) != nullptr; }

void check_compression(const Path& file, const json& gltf, const Container& container) {
    const std::set<std::size_t> without_bytes = stand_ins(gltf, container);
    for (std::size_t i = 0; i < list_of(gltf, "bufferViews").size(); ++i)
        check_meshopt(file, gltf, without_bytes, i);
    for (std::size_t mesh = 0; mesh < list_of(gltf, "meshes").size(); ++mesh) {
        const json& primitives = gltf["meshes"][mesh]["primitives"];
        for (std::size_t i = 0; i < primitives.size(); ++i)
            check_draco(file, primitives[i], pointer("meshes", mesh, pointer("primitives", i)));
    }
}

CompressedMeshes take_out_compressed(json& gltf, const Container& container) {
    CompressedMeshes compressed;
    const json& views = list_of(gltf, "bufferViews");
    for (std::size_t i = 0; i < views.size(); ++i)
        if (const json* extension = meshopt_of(views[i]))
            compressed.views.emplace(i, meshopt_view(*extension));
    for (std::size_t mesh = 0; mesh < list_of(gltf, "meshes").size(); ++mesh) {
        json& primitives = gltf["meshes"][mesh]["primitives"];
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const json* extension = draco_of(primitives[i]);
            if (extension == nullptr) continue;
            compressed.primitives.push_back(draco_primitive(mesh, i, primitives[i], *extension));
            primitives[i].erase("indices");
        }
    }
    for (const std::size_t i : stand_ins(gltf, container))
        gltf["buffers"][i] = {{"byteLength", 1}, {"uri", "data:application/octet-stream;base64,AA=="}};
    return compressed;
}

void put_indices_back(const CompressedMeshes& compressed, tinygltf::Model& model) {
    for (const DracoPrimitive& draco : compressed.primitives)
        model.meshes[draco.mesh].primitives[draco.primitive].indices = draco.indices;
}

void decode_compressed(const Path& file, const CompressedMeshes& compressed, tinygltf::Model& model) {
    Decompression decompression(file, model);
    for (const auto& [view, meshopt] : compressed.views) decompression.fill(view, meshopt);
    for (const DracoPrimitive& draco : compressed.primitives) decompression.fill(draco);
}

}  // namespace zproof
