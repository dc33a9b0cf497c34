#include "scenes/gltf/check.h"

#include <algorithm>
#include <numbers>
#include <optional>

#include "scenes/gltf/accessor.h"
#include "scenes/limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

const auto& at(const auto& list, int index) { return list[static_cast<std::size_t>(index)]; }

std::size_t components_of(const tinygltf::Accessor& accessor) {
    return static_cast<std::size_t>(
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
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
    Check(const std::filesystem::path& file, const tinygltf::Model& model) : file_(file), model_(model) {}

    void accessor(std::size_t i) const {
        const tinygltf::Accessor& accessor = model_.accessors[i];
        const std::string place = pointer("accessors", i);
        const std::size_t components = components_of(accessor);
        for (const auto& [bound, values] :
             {std::pair("/min", &accessor.minValues), {"/max", &accessor.maxValues}})
            if (!values->empty() && values->size() != components)
                refuse(file_, place + bound,
                       "has " + std::to_string(values->size()) + " numbers, expected " +
                           std::to_string(components) + export_again);
        const std::size_t size = components * component_bytes(accessor.componentType);
        if (accessor.bufferView >= 0)
            run(place, {accessor.bufferView, accessor.byteOffset, size, accessor.count});
        if (accessor.sparse.isSparse) sparse(place + "/sparse", accessor, size);
    }

    void primitive(const std::string& place, const tinygltf::Primitive& primitive) const {
        std::optional<std::size_t> count;
        for (const auto& [name, index] : primitive.attributes) {
            const tinygltf::Accessor& accessor = at(model_.accessors, index);
            if (count.value_or(accessor.count) != accessor.count)
                refuse(file_, place + "/attributes/" + name,
                       "has " + std::to_string(accessor.count) + " elements, another attribute has " +
                           std::to_string(*count) + "; expected as many" + export_again);
            count = accessor.count;
            attribute(place + "/attributes/" + name, name, accessor);
        }
        if (primitive.indices >= 0) indices(place + "/indices", at(model_.accessors, primitive.indices));
    }

    void camera(std::size_t i) const {
        const tinygltf::Camera& camera = model_.cameras[i];
        const std::string place = pointer("cameras", i, "/" + camera.type);
        if (camera.type == "perspective") {
            const tinygltf::PerspectiveCamera& intrinsics = camera.perspective;
            if (!(intrinsics.yfov < std::numbers::pi))
                refuse(file_, place + "/yfov",
                       "expected an angle between 0 and pi, found " + std::to_string(intrinsics.yfov));
            if (intrinsics.zfar != 0 && !(intrinsics.zfar > intrinsics.znear))
                refuse(file_, place + "/zfar",
                       "expected a distance above znear, " + std::to_string(intrinsics.znear));
        } else {
            const tinygltf::OrthographicCamera& intrinsics = camera.orthographic;
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
        const tinygltf::BufferView& view = at(model_.bufferViews, run.view);
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

    void sparse(const std::string& place, const tinygltf::Accessor& accessor, std::size_t size) const {
        const auto& indices = accessor.sparse.indices;
        const auto& values = accessor.sparse.values;
        const auto count = static_cast<std::size_t>(accessor.sparse.count);
        if (count > accessor.count)
            refuse(file_, place + "/count",
                   std::to_string(count) + "; expected at most the accessor's count, " +
                       std::to_string(accessor.count) + export_again);
        const auto packed = [&](const std::string& part, int view, auto offset, std::size_t bytes) {
            if (at(model_.bufferViews, view).byteStride != 0)
                refuse(file_, place + part, "expected a buffer view without byteStride" + export_again);
            run(place + part, {view, static_cast<std::size_t>(offset), bytes, count});
        };
        packed("/indices", indices.bufferView, indices.byteOffset, component_bytes(indices.componentType));
        packed("/values", values.bufferView, values.byteOffset, size);
    }

    void attribute(const std::string& place, const std::string& name,
                   const tinygltf::Accessor& accessor) const {
        const int component = accessor.componentType;
        const bool is_float = component == TINYGLTF_COMPONENT_TYPE_FLOAT;
        const bool is_quantized = is_quantized_ && component <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
        const bool is_unit = accessor.normalized && (component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                                     component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
        const auto expect = [&](bool is_met, const char* expected) {
            if (!is_met) refuse(file_, place, std::string("expected ") + expected + export_again);
        };
        if (name == "POSITION" || name == "NORMAL")
            expect(accessor.type == TINYGLTF_TYPE_VEC3 && (is_float || is_quantized),
                   "VEC3 of FLOAT, or 8 and 16 bit integers with KHR_mesh_quantization");
        else if (name.starts_with("TEXCOORD_"))
            expect(accessor.type == TINYGLTF_TYPE_VEC2 && (is_float || is_unit || is_quantized),
                   "VEC2 of FLOAT or of normalized UNSIGNED_BYTE or UNSIGNED_SHORT");
        else if (name.starts_with("COLOR_"))
            expect((accessor.type == TINYGLTF_TYPE_VEC3 || accessor.type == TINYGLTF_TYPE_VEC4) &&
                       (is_float || is_unit),
                   "VEC3 or VEC4 of FLOAT or of normalized UNSIGNED_BYTE or UNSIGNED_SHORT");
    }

    void indices(const std::string& place, const tinygltf::Accessor& accessor) const {
        const int component = accessor.componentType;
        const bool is_unsigned = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                 component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                 component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        if (accessor.type != TINYGLTF_TYPE_SCALAR || !is_unsigned || accessor.normalized)
            refuse(file_, place,
                   "expected SCALAR of UNSIGNED_BYTE, UNSIGNED_SHORT or UNSIGNED_INT" + export_again);
    }

    const std::filesystem::path& file_;
    const tinygltf::Model& model_;
    const bool is_quantized_ =
        std::ranges::find(model_.extensionsUsed, "KHR_mesh_quantization") != model_.extensionsUsed.end();
};

}  // namespace

std::vector<std::string> check_model(const std::filesystem::path& file, const tinygltf::Model& model) {
    const Check check(file, model);
    std::vector<int> parents(model.nodes.size(), 0);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children) ++parents[static_cast<std::size_t>(child)];
    check.nodes(parents);
    for (std::size_t i = 0; i < model.scenes.size(); ++i) check.scene_roots(i, parents);
    for (std::size_t i = 0; i < model.accessors.size(); ++i) check.accessor(i);
    for (std::size_t mesh = 0; mesh < model.meshes.size(); ++mesh)
        for (std::size_t i = 0; i < model.meshes[mesh].primitives.size(); ++i)
            check.primitive(pointer("meshes", mesh, pointer("primitives", i)),
                            model.meshes[mesh].primitives[i]);
    for (std::size_t i = 0; i < model.cameras.size(); ++i) check.camera(i);
    const auto shared = std::ranges::count_if(parents, [](int count) { return count > 1; });
    if (shared == 0) return {};
    return {"nodes with several parents, against glTF's rules, drawn once for each: " +
            std::to_string(shared)};
}

}  // namespace zproof
