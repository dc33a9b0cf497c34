#include "scenes/gltf/check.h"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <optional>

#include "scenes/gltf/accessor.h"
#include "scenes/gltf/compression.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

/// Extensions that change nothing that is baked, or that the loader follows.
constexpr std::string_view known_extensions[] = {
    "KHR_texture_transform",      "KHR_mesh_quantization",
    "KHR_materials_unlit",        "KHR_lights_punctual",
    "KHR_materials_ior",          "KHR_materials_sheen",
    "KHR_materials_clearcoat",    "KHR_materials_specular",
    "KHR_materials_iridescence",  "KHR_materials_anisotropy",
    "KHR_materials_transmission", "KHR_materials_volume",
    "KHR_materials_dispersion",   "KHR_materials_emissive_strength"};

bool is_known(const std::string& extension) {
    return std::ranges::find(known_extensions, extension) != std::end(known_extensions);
}

/// The remedy where a file contradicts itself.
const std::string export_again = "; export the file again";

/// Elements in a row within a buffer view.
struct Run {
    int view = -1;
    std::size_t offset = 0, size = 0, count = 0;
};

class Check {
  public:
    explicit Check(const GltfModel& model) : model_(model.document), file_(model.file), chunk_(model.chunk) {}

    /// Gives a note for unknown extensions that are not required.
    std::vector<std::string> extensions() const {
        const std::vector<std::string>& required = model_.extensionsRequired;
        for (std::size_t i = 0; i < required.size(); ++i)
            if (const std::string& name = required[i]; !is_known(name) && !is_decoded(name))
                refuse(file_, pointer("extensionsRequired", i),
                       compressor_of(name).empty()
                           ? "extension " + name + " is not supported; export the file without it"
                           : refusal_of_compression(name));
        std::string ignored;
        for (const std::string& name : model_.extensionsUsed)
            if (!is_known(name) && !is_decoded(name)) ignored += (ignored.empty() ? "" : ", ") + name;
        if (ignored.empty()) return {};
        return {on_one_line("extensions ignored: " + ignored)};
    }

    void buffer_view(std::size_t i) const {
        const gltf::BufferView& view = model_.bufferViews[i];
        const std::size_t bytes = at(model_.buffers, view.buffer).byteLength;
        if (view.byteOffset + view.byteLength > bytes)
            refuse(file_, pointer("bufferViews", i),
                   "needs " + std::to_string(view.byteLength) + " bytes at " +
                       std::to_string(view.byteOffset) + ", its buffer has " + std::to_string(bytes) +
                       export_again);
    }

    void source(const std::string& place, const gltf::Primitive& primitive) const {
        for (const auto& [name, extension] : primitive.extensions.items())
            if (!compressor_of(name).empty() && !is_decoded(name))
                refuse(file_, place, refusal_of_compression(name));
        if (primitive.indices >= 0 && !is_draco_primitive(primitive) &&
            at(model_.accessors, primitive.indices).bufferView < 0)
            refuse(file_, place + "/indices", "expected an accessor with a bufferView" + export_again);
    }

    void image(std::size_t i) const {
        const gltf::Image& image = model_.images[i];
        if (image.uri.empty() == (image.bufferView < 0))
            refuse(file_, pointer("images", i), "expected either uri or bufferView");
        if (tinygltf::IsDataURI(image.uri)) data_bytes(pointer("images", i, "/uri"), image.uri);
    }

    /// What is not in a file of its own has all the bytes that the buffer declares.
    void buffer(std::size_t i) const {
        const gltf::Buffer& buffer = model_.buffers[i];
        const bool is_chunk = buffer.uri.empty();
        if (is_chunk && (i > 0 || chunk_.data() == nullptr))
            refuse(file_, pointer("buffers", i),
                   "has no uri; only the first buffer of a GLB with a BIN chunk may lack it");
        if (!is_chunk && !tinygltf::IsDataURI(buffer.uri)) return;
        const std::size_t there =
            is_chunk ? chunk_.size() : data_bytes(pointer("buffers", i, "/uri"), buffer.uri);
        if (there < buffer.byteLength || (!is_chunk && there > buffer.byteLength))
            refuse(file_, pointer("buffers", i, "/byteLength"),
                   std::string("the ") + (is_chunk ? "BIN chunk" : "data URI") + " holds " +
                       std::to_string(there) + " bytes, expected " + std::to_string(buffer.byteLength) +
                       export_again);
    }

    void accessor(std::size_t i) const {
        const gltf::Accessor& accessor = model_.accessors[i];
        const std::string place = pointer("accessors", i);
        const auto components = static_cast<std::size_t>(component_count(accessor.type));
        for (const auto& [bound, values] : {std::pair("/min", &accessor.min), {"/max", &accessor.max}})
            if (!values->empty() && values->size() != components)
                refuse(file_, place + bound,
                       "has " + std::to_string(values->size()) + " numbers, expected " +
                           std::to_string(components) + export_again);
        const std::size_t size = components * component_bytes(accessor.componentType);
        if (accessor.bufferView >= 0)
            run(place, {accessor.bufferView, accessor.byteOffset, size, accessor.count});
        if (accessor.sparse.count > 0) sparse(place + "/sparse", accessor, size);
    }

    void primitive(const std::string& place, const gltf::Primitive& primitive) const {
        std::optional<std::size_t> count;
        for (const auto& [name, index] : primitive.attributes) {
            const gltf::Accessor& accessor = at(model_.accessors, index);
            if (count.value_or(accessor.count) != accessor.count)
                refuse(file_, place + "/attributes/" + name,
                       "has " + std::to_string(accessor.count) + " elements, another attribute has " +
                           std::to_string(*count) + "; expected as many" + export_again);
            count = accessor.count;
            attribute(place + "/attributes/" + name, name, accessor);
        }
        if (primitive.indices >= 0) indices(place + "/indices", at(model_.accessors, primitive.indices));
    }

    void weights(const std::string& place, const std::vector<double>& weights, const gltf::Mesh& mesh) const {
        for (const gltf::Primitive& primitive : mesh.primitives)
            if (!weights.empty() && weights.size() != primitive.targets.size())
                refuse(file_, place + "/weights",
                       "has " + std::to_string(weights.size()) + " numbers, a primitive of the mesh " +
                           std::to_string(primitive.targets.size()) + " morph targets; expected as many" +
                           export_again);
    }

    void node(std::size_t i) const {
        const gltf::Node& node = model_.nodes[i];
        const bool is_in_parts = !node.translation.empty() || !node.rotation.empty() || !node.scale.empty();
        if (!node.matrix.empty() && is_in_parts)
            refuse(file_, pointer("nodes", i),
                   "has a matrix beside translation, rotation or scale; expected either" + export_again);
        if (node.mesh >= 0) weights(pointer("nodes", i), node.weights, at(model_.meshes, node.mesh));
    }

    void camera(std::size_t i) const {
        const gltf::Camera& camera = model_.cameras[i];
        const std::string place = pointer("cameras", i, "/" + camera.type);
        const bool is_perspective = camera.type == "perspective";
        if ((is_perspective ? camera.perspective.yfov : camera.orthographic.xmag) == 0)
            refuse(file_, place, "is missing; a camera of this type requires it");
        if (is_perspective) {
            const gltf::Perspective& intrinsics = camera.perspective;
            if (!(intrinsics.yfov < std::numbers::pi))
                refuse(file_, place + "/yfov",
                       "expected an angle between 0 and pi, found " + std::to_string(intrinsics.yfov));
            if (intrinsics.zfar != 0 && !(intrinsics.zfar > intrinsics.znear))
                refuse(file_, place + "/zfar",
                       "expected a distance above znear, " + std::to_string(intrinsics.znear));
        } else {
            const gltf::Orthographic& intrinsics = camera.orthographic;
            if (!(intrinsics.znear >= 0))
                refuse(file_, place + "/znear",
                       "expected a distance of 0 or more, found " + std::to_string(intrinsics.znear));
            if (!(intrinsics.zfar > intrinsics.znear))
                refuse(file_, place + "/zfar",
                       "expected a distance above znear, " + std::to_string(intrinsics.znear));
        }
    }

    /// Visits every node after all its parents (Kahn 1962): what is left is on or below a cycle. The ways
    /// that lead to a node, once each of which it is drawn, are summed up, never enumerated.
    void nodes(const std::vector<int>& parents) const {
        std::vector<int> waiting_for = parents;
        std::vector<std::size_t> open, depth(parents.size(), 1), ways(parents.size(), 0);
        for (std::size_t node = 0; node < parents.size(); ++node) {
            if (parents[node] > 0) continue;
            open.push_back(node);
            ways[node] = 1;
        }
        std::size_t placed = 0;
        for (std::size_t next = 0; next < open.size(); ++next) {
            const std::size_t node = open[next];
            within_limits(node, depth[node], placed += ways[node]);
            for (const int each : model_.nodes[node].children) {
                const auto child = static_cast<std::size_t>(each);
                depth[child] = std::max(depth[child], depth[node] + 1);
                ways[child] += ways[node];
                if (--waiting_for[child] == 0) open.push_back(child);
            }
        }
        for (std::size_t node = 0; node < parents.size(); ++node)
            if (waiting_for[node] != 0)
                refuse(file_, pointer("nodes", node), "is its own ancestor; expected a tree");
    }

    void scene_roots(std::size_t scene, const std::vector<int>& parents) const {
        std::vector<bool> is_listed(parents.size(), false);
        for (const int node : model_.scenes[scene].nodes) {
            const auto index = static_cast<std::size_t>(node);
            if (parents[index] > 0 || is_listed[index])
                refuse(file_, pointer("scenes", scene, "/nodes"),
                       "node " + std::to_string(node) +
                           (is_listed[index] ? " is listed twice; expected each root once"
                                             : " has a parent; expected roots"));
            is_listed[index] = true;
        }
    }

  private:
    void within_limits(std::size_t node, std::size_t depth, std::size_t placed) const {
        if (depth > limits::node_depth)
            refuse(file_, pointer("nodes", node),
                   "nested too deep: at most " + std::to_string(limits::node_depth) +
                       " nodes; flatten the hierarchy");
        if (placed > limits::placed_nodes)
            refuse(file_, pointer("nodes", node),
                   "nodes with several parents draw more than " + std::to_string(limits::placed_nodes) +
                       " nodes; expected a tree");
    }

    /// Offsets, counts and sizes are integers below 2^31 and the stride is at most 252: no sum or product
    /// wraps.
    void run(const std::string& place, const Run& run) const {
        const gltf::BufferView& view = at(model_.bufferViews, run.view);
        const std::size_t stride = view.byteStride != 0 ? view.byteStride : run.size;
        if (stride < run.size)
            refuse(file_, place,
                   "byteStride " + std::to_string(stride) + " is less than an element's " +
                       std::to_string(run.size) + " bytes" + export_again);
        const std::size_t needed = stride * (run.count - 1) + run.size;
        if (run.offset + needed > view.byteLength)
            refuse(file_, place,
                   std::to_string(run.count) + " elements of " + std::to_string(run.size) + " bytes need " +
                       std::to_string(needed) + " bytes at " + std::to_string(run.offset) + ", bufferView " +
                       std::to_string(run.view) + " has " + std::to_string(view.byteLength) + export_again);
    }

    void sparse(const std::string& place, const gltf::Accessor& accessor, std::size_t size) const {
        const auto& indices = accessor.sparse.indices;
        const auto& values = accessor.sparse.values;
        const std::size_t count = accessor.sparse.count;
        if (count > accessor.count)
            refuse(file_, place + "/count",
                   std::to_string(count) + "; expected at most the accessor's count, " +
                       std::to_string(accessor.count) + export_again);
        const auto packed = [&](const std::string& part, const gltf::SparsePart& at_view, std::size_t bytes) {
            if (at(model_.bufferViews, at_view.bufferView).byteStride != 0)
                refuse(file_, place + part, "expected a buffer view without byteStride" + export_again);
            run(place + part, {at_view.bufferView, at_view.byteOffset, bytes, count});
        };
        packed("/indices", indices, component_bytes(indices.componentType));
        packed("/values", values, size);
    }

    void attribute(const std::string& place, const std::string& name, const gltf::Accessor& accessor) const {
        const int component = accessor.componentType;
        const bool is_float = component == TINYGLTF_COMPONENT_TYPE_FLOAT;
        const bool is_quantized = is_quantized_ && component <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
        const bool is_unit = accessor.normalized && (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                                     component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
        const auto expect = [&](bool is_met, const char* expected) {
            if (!is_met) refuse(file_, place, std::string("expected ") + expected + export_again);
        };
        if (name == "POSITION" || name == "NORMAL")
            expect(accessor.type == "VEC3" && (is_float || is_quantized),
                   "VEC3 of FLOAT, or 8 and 16 bit integers with KHR_mesh_quantization");
        else if (name.starts_with("TEXCOORD_"))
            expect(accessor.type == "VEC2" && (is_float || is_unit || is_quantized),
                   "VEC2 of FLOAT or of normalized UNSIGNED_BYTE or UNSIGNED_SHORT");
        else if (name.starts_with("COLOR_"))
            expect((accessor.type == "VEC3" || accessor.type == "VEC4") && (is_float || is_unit),
                   "VEC3 or VEC4 of FLOAT or of normalized UNSIGNED_BYTE or UNSIGNED_SHORT");
    }

    void indices(const std::string& place, const gltf::Accessor& accessor) const {
        const int component = accessor.componentType;
        const bool is_unsigned = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                 component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                 component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        if (accessor.type != "SCALAR" || !is_unsigned || accessor.normalized)
            refuse(file_, place,
                   "expected SCALAR of UNSIGNED_BYTE, UNSIGNED_SHORT or UNSIGNED_INT" + export_again);
    }

    /// The number of bytes that a data URI holds, all of which are base64.
    std::size_t data_bytes(const std::string& place, const std::string& uri) const {
        const auto is_base64 = [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '/'; };
        const auto first = std::ranges::find(uri, ',') + 1,
                   end = std::find_if_not(first, uri.end(), is_base64);
        if (end != uri.end() && *end != '=')
            refuse(file_, place, "not base64 at character " + std::to_string(end - first) + export_again);
        if (end - first < 2)
            refuse(file_, place, "expected base64 behind the comma, found nothing" + export_again);
        return static_cast<std::size_t>(end - first) * 3 / 4;
    }

    const gltf::Document& model_;
    const std::filesystem::path& file_;
    std::span<const unsigned char> chunk_;
    const bool is_quantized_ =
        std::ranges::find(model_.extensionsUsed, "KHR_mesh_quantization") != model_.extensionsUsed.end();
};

/// Calls visit(place, primitive) for every primitive.
void each_primitive(const gltf::Document& model, const auto& visit) {
    for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh)
        for (std::size_t i = 0; i < model.meshes[mesh].primitives.size(); ++i)
            visit(pointer("meshes", mesh, pointer("primitives", i)), model.meshes[mesh].primitives[i]);
}

/// The number of parents of each node.
std::vector<int> parent_counts(const gltf::Document& model) {
    std::vector<int> parents(model.nodes.size(), 0);
    for (const gltf::Node& node : model.nodes)
        for (const int child : node.children) ++at(parents, child);
    return parents;
}

void check_bytes(const GltfModel& model, const Check& check) {
    const gltf::Document& document = model.document;
    for (std::size_t i = 0; i < document.bufferViews.size(); ++i) check.buffer_view(i);
    each_primitive(document, [&](const auto&... primitive) { check.source(primitive...); });
    check_compression(model);
    for (std::size_t i = 0; i < document.images.size(); ++i) check.image(i);
    const std::set<int> without_bytes = stand_ins(model);
    for (std::size_t i = 0; i < document.buffers.size(); ++i)
        if (!without_bytes.contains(static_cast<int>(i))) check.buffer(i);
}

}  // namespace

std::vector<std::string> check_model(const GltfModel& model) {
    const Check check(model);
    const gltf::Document& document = model.document;
    std::vector<std::string> notes = check.extensions();
    check_bytes(model, check);
    const std::vector<int> parents = parent_counts(document);
    check.nodes(parents);
    for (std::size_t i = 0; i < document.scenes.size(); ++i) check.scene_roots(i, parents);
    for (std::size_t i = 0; i < document.accessors.size(); ++i) check.accessor(i);
    each_primitive(document, [&](const auto&... primitive) { check.primitive(primitive...); });
    for (std::size_t i = 0; i < document.meshes.size(); ++i)
        check.weights(pointer("meshes", i), document.meshes[i].weights, document.meshes[i]);
    for (std::size_t i = 0; i < document.nodes.size(); ++i) check.node(i);
    for (std::size_t i = 0; i < document.cameras.size(); ++i) check.camera(i);
    if (const auto shared = std::ranges::count_if(parents, [](int count) { return count > 1; }); shared > 0)
        notes.push_back("nodes with several parents, against glTF's rules, drawn once for each: " +
                        std::to_string(shared));
    return notes;
}

}  // namespace zproof
