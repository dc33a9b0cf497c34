#include "scenes/gltf/compression.h"

#include <array>
#include <cstring>
#include <span>
#include <utility>

#include "scenes/gltf/accessor.h"
#include "scenes/gltf/decoders.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

constexpr const char* draco_extension = "KHR_draco_mesh_compression";
constexpr std::array meshopt_extensions{"EXT_meshopt_compression", "KHR_meshopt_compression"};

const json* meshopt_of(const json& extensions) {
    if (!has_meshopt()) return nullptr;
    for (const char* name : meshopt_extensions)
        if (const auto found = extensions.find(name); found != extensions.end()) return &*found;
    return nullptr;
}

const json* draco_of(const gltf::Primitive& primitive) {
    const auto found = primitive.extensions.find(draco_extension);
    return has_draco() && found != primitive.extensions.end() ? &*found : nullptr;
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

void check_meshopt(const GltfModel& model, const std::set<int>& without_bytes, std::size_t i) {
    const gltf::BufferView& declared = model.document.bufferViews[i];
    const json* extension = meshopt_of(declared.extensions);
    const std::string place = pointer("bufferViews", i);
    if (extension == nullptr) {
        if (without_bytes.contains(declared.buffer))
            refuse(model.file, place,
                   "its buffer has no bytes and it is not compressed; export the file again");
        return;
    }
    const MeshoptView view = meshopt_view(*extension);
    if (std::string fault = fault_of(view); !fault.empty())
        refuse(model.file, place, "meshopt: " + fault + "; export the file again");
    if (view.stride * view.count != declared.byteLength)
        refuse(model.file, place,
               "meshopt: byteStride x count is " + std::to_string(view.stride * view.count) +
                   ", expected the view's byteLength; export the file again");
    const std::size_t there =
        without_bytes.contains(view.buffer) ? 0 : at(model.document.buffers, view.buffer).byteLength;
    if (view.offset + view.bytes > there)
        refuse(model.file, place,
               "meshopt: needs " + std::to_string(view.bytes) + " bytes at " + std::to_string(view.offset) +
                   ", its buffer has " + std::to_string(there) + "; export the file again");
}

void check_draco(const Path& file, const gltf::Primitive& primitive, const std::string& place) {
    const json* extension = draco_of(primitive);
    if (extension == nullptr) return;
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES)
        refuse(file, place, "compressed with Draco; expected mode 4, triangles: export without compression");
    for (const auto& [name, id] : (*extension)["attributes"].items())
        if (!primitive.attributes.contains(name))
            refuse(file, place,
                   "Draco has " + name + "; expected it in attributes too: export the file again");
}

/// Attributes that are baked; no others are decoded.
bool is_baked(std::string_view attribute) {
    return attribute == "POSITION" || attribute == "NORMAL" || attribute == "COLOR_0" ||
           attribute.starts_with("TEXCOORD_");
}

/// A primitive whose triangles Draco has.
struct DracoPrimitive {
    gltf::Primitive& primitive;
    std::string place;
    int view = -1;                             ///< where the stream lies
    std::map<std::string, std::uint32_t> ids;  ///< in the stream, by the attribute's name

    DracoPrimitive(gltf::Primitive& compressed, const json& extension, std::string where)
        : primitive(compressed), place(std::move(where)), view(extension["bufferView"]) {
        for (const auto& [name, id] : extension["attributes"].items())
            if (is_baked(name)) ids.emplace(name, id.get<std::uint32_t>());
    }
};

Bytes bytes_of(std::span<const std::uint32_t> values) {
    Bytes bytes(values.size_bytes());
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

/// Decodes what is compressed, within a limit for all together.
class Decompression {
  public:
    explicit Decompression(GltfModel& model) : file_(model.file), document_(model.document) {}

    void fill(std::size_t index, const MeshoptView& meshopt) {
        const std::string place = pointer("bufferViews", index);
        allow(place, meshopt.stride * meshopt.count);
        Bytes bytes(meshopt.stride * meshopt.count);
        const std::span<const unsigned char> source = at(document_.buffers, meshopt.buffer).data();
        if (!decode_meshopt(meshopt, source.subspan(meshopt.offset, meshopt.bytes), bytes))
            refuse(file_, place, "meshopt cannot decode its " + meshopt.mode + "; export the file again");
        document_.bufferViews[index].buffer = add_buffer(std::move(bytes));
        document_.bufferViews[index].byteOffset = 0;
    }

    void fill(const DracoPrimitive& draco) {
        const gltf::BufferView& view = at(document_.bufferViews, draco.view);
        const std::span<const unsigned char> stream =
            at(document_.buffers, view.buffer).data().subspan(view.byteOffset, view.byteLength);
        const DracoMesh expected = expected_of(draco);
        const std::uint64_t triangles = draco_triangles(stream).value_or(0);
        std::uint64_t vertex_bytes = 0;
        for (const DracoAttribute& each : expected.attributes)
            vertex_bytes +=
                static_cast<std::uint64_t>(each.components) * component_bytes(each.component_type);
        allow(draco.place, 12 * triangles + vertex_bytes * expected.vertices);
        DecodedDraco decoded = decode_draco(stream, expected);
        if (!decoded.fault.empty()) refuse(file_, draco.place, decoded.fault + "; export the file again");
        put(draco, std::move(decoded));
    }

  private:
    void allow(const std::string& place, std::uint64_t bytes) {
        decoded_bytes_ += bytes;
        if (decoded_bytes_ > limits::decoded_bytes)
            refuse(file_, place,
                   "compressed meshes need more than " + std::to_string(limits::decoded_bytes) +
                       " bytes decoded; split the scene");
    }

    int add_buffer(Bytes bytes) {
        document_.buffers.emplace_back().own = std::move(bytes);
        return static_cast<int>(document_.buffers.size()) - 1;
    }

    /// The accessor over bytes of its own.
    int add_accessor(gltf::Accessor accessor, Bytes bytes) {
        gltf::BufferView view;
        view.byteLength = bytes.size();
        view.buffer = add_buffer(std::move(bytes));
        document_.bufferViews.push_back(std::move(view));
        accessor.bufferView = static_cast<int>(document_.bufferViews.size()) - 1;
        accessor.byteOffset = 0;
        document_.accessors.push_back(std::move(accessor));
        return static_cast<int>(document_.accessors.size()) - 1;
    }

    DracoMesh expected_of(const DracoPrimitive& draco) const {
        DracoMesh mesh;
        if (const int indices = draco.primitive.indices; indices >= 0)
            mesh.corners = at(document_.accessors, indices).count;
        for (const auto& [name, id] : draco.ids) {
            const gltf::Accessor& declared = at(document_.accessors, draco.primitive.attributes.at(name));
            mesh.vertices = declared.count;
            mesh.attributes.push_back({id, declared.componentType, component_count(declared.type)});
        }
        return mesh;
    }

    /// Accessors are copied: other primitives may name the same ones over other data.
    void put(const DracoPrimitive& draco, DecodedDraco decoded) {
        std::size_t i = 0;
        for (const auto& [name, id] : draco.ids) {
            int& index = draco.primitive.attributes.at(name);
            index = add_accessor(gltf::Accessor(at(document_.accessors, index)),
                                 std::move(decoded.attributes[i++]));
        }
        gltf::Accessor indices;
        indices.type = "SCALAR";
        indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        indices.count = decoded.indices.size();
        draco.primitive.indices = add_accessor(std::move(indices), bytes_of(decoded.indices));
    }

    const Path& file_;
    gltf::Document& document_;
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

std::set<int> stand_ins(const GltfModel& model) {
    const std::vector<gltf::Buffer>& buffers = model.document.buffers;
    std::vector<int> plain(buffers.size()), compressed(buffers.size());
    for (const gltf::BufferView& view : model.document.bufferViews)
        ++at(meshopt_of(view.extensions) == nullptr ? plain : compressed, view.buffer);
    std::set<int> found;
    for (std::size_t i = model.chunk.data() == nullptr ? 0 : 1; i < buffers.size(); ++i) {
        const bool is_named_only = plain[i] == 0 && compressed[i] > 0;
        if (buffers[i].uri.empty() && (meshopt_of(buffers[i].extensions) != nullptr || is_named_only))
            found.insert(static_cast<int>(i));
    }
    return found;
}

bool is_draco_primitive(const gltf::Primitive& primitive) { return draco_of(primitive) != nullptr; }

void check_compression(const GltfModel& model) {
    const std::set<int> without_bytes = stand_ins(model);
    for (std::size_t i = 0; i < model.document.bufferViews.size(); ++i)
        check_meshopt(model, without_bytes, i);
    for (std::size_t mesh = 0; mesh < model.document.meshes.size(); ++mesh) {
        const std::vector<gltf::Primitive>& primitives = model.document.meshes[mesh].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i)
            check_draco(model.file, primitives[i], pointer("meshes", mesh, pointer("primitives", i)));
    }
}

void decode_compressed(GltfModel& model) {
    Decompression decompression(model);
    for (std::size_t i = 0, count = model.document.bufferViews.size(); i < count; ++i)
        if (const json* extension = meshopt_of(model.document.bufferViews[i].extensions))
            decompression.fill(i, meshopt_view(*extension));
    for (std::size_t mesh = 0; mesh < model.document.meshes.size(); ++mesh) {
        std::vector<gltf::Primitive>& primitives = model.document.meshes[mesh].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i)
            if (const json* extension = draco_of(primitives[i]))
                decompression.fill(
                    {primitives[i], *extension, pointer("meshes", mesh, pointer("primitives", i))});
    }
}

}  // namespace zproof
