#include "scenes/gltf_bake.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "scenes/gltf_accessor.h"
#include "scenes/gltf_corners.h"
#include "scenes/gltf_limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

/// Coordinates beyond this are noted: their squares overflow float32, though they themselves do not.
constexpr double square_overflows = 1.8e19;

struct Tally {
    std::uint64_t points_and_lines = 0, without_position = 0, tails = 0, singular = 0, skinned = 0,
                  morphed = 0;
    std::uint64_t flat = 0, instancing = 0;
    bool is_huge = false;
};

/// Inverse transpose up to a positive factor, without a division: cofactors, turned round where the
/// determinant is negative.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

std::optional<int> attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? std::nullopt : std::optional(found->second);
}

/// Calls work(from, to) for ranges that make up [first, end), side by side.
template <typename Work>
void in_parallel(std::size_t first, std::size_t end, const Work& work) {
    constexpr std::size_t worth_a_task = 1 << 14;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(first, end, worth_a_task),
                      [&](const auto& some) { work(some.begin(), some.end()); });
}

bool is_unbounded(const glm::vec3& p) {
    return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z);
}

/// The largest absolute coordinate; infinite where one is infinite or no number.
float largest_coordinate(std::span<const glm::vec3> positions) {
    std::uint32_t largest =
        0;  // without a sign, the bits of floats rise as they do, and those of NaN are highest
    for (const glm::vec3& p : positions)
        for (const float c : {p.x, p.y, p.z})
            largest = std::max(largest, std::bit_cast<std::uint32_t>(c) & 0x7FFF'FFFFu);
    const float value = std::bit_cast<float>(largest);
    return std::isnan(value) ? std::numeric_limits<float>::infinity() : value;
}

class Baker {
  public:
    Baker(const GltfModel& model, Scene& scene)
        : model_(model), scene_(scene), accessors_(model), unroller_(model, accessors_) {}

    void reserve(const std::vector<PlacedNode>& nodes) {
        std::uint64_t triangles = 0, vertices = 0;
        for (const PlacedNode& placed : nodes)
            for (const tinygltf::Primitive& primitive : primitives_of(placed)) {
                const std::uint64_t corners = corner_count(primitive);
                triangles += triangle_count(primitive.mode, corners);
                vertices += std::min(corners, vertex_count(primitive));
                check_limits(triangles, vertices);
            }
        scene_.triangles.reserve(triangles);
        scene_.vertices.position_world.reserve(vertices);
    }

    void bake(const PlacedNode& placed) {
        const tinygltf::Node& node = node_of(placed);
        if (node.mesh < 0) return;
        tally_.instancing += node.extensions.contains("EXT_mesh_gpu_instancing");
        const std::vector<tinygltf::Primitive>& primitives = primitives_of(placed);
        for (std::size_t i = 0; i < primitives.size(); ++i) bake(placed, static_cast<int>(i), primitives[i]);
        tally_.singular += glm::determinant(glm::dmat3(placed.world_from_node)) == 0;
        tally_.skinned += node.skin >= 0;
        tally_.morphed +=
            std::ranges::any_of(primitives, [](const auto& each) { return !each.targets.empty(); });
    }

    /// Pads attributes that the last primitives lack, and says what was left out.
    void finish() {
        Vertices& vertices = scene_.vertices;
        const std::size_t size = vertices.position_world.size();
        if (!vertices.normal_world.empty()) vertices.normal_world.resize(size, glm::vec3(0));
        for (auto& set : vertices.uv) set.resize(size, glm::vec2(0));
        if (!vertices.color.empty()) vertices.color.resize(size, glm::vec4(1));
        note_tally();
    }

  private:
    const tinygltf::Node& node_of(const PlacedNode& placed) const {
        return model_.gltf.nodes[static_cast<std::size_t>(placed.node)];
    }

    const std::vector<tinygltf::Primitive>& primitives_of(const PlacedNode& placed) const {
        static const std::vector<tinygltf::Primitive> none;
        const int mesh = node_of(placed).mesh;
        return mesh < 0 ? none : model_.gltf.meshes[static_cast<std::size_t>(mesh)].primitives;
    }

    std::uint64_t vertex_count(const tinygltf::Primitive& primitive) const {
        const std::optional<int> position = attribute(primitive, "POSITION");
        return position ? model_.gltf.accessors[static_cast<std::size_t>(*position)].count : 0;
    }

    std::uint64_t corner_count(const tinygltf::Primitive& primitive) const {
        if (primitive.indices < 0 || !attribute(primitive, "POSITION")) return vertex_count(primitive);
        return model_.gltf.accessors[static_cast<std::size_t>(primitive.indices)].count;
    }

    void check_limits(std::uint64_t triangles, std::uint64_t vertices) const {
        if (triangles > limits::triangles || vertices > limits::vertices)
            refuse(model_.file, "scene",
                   "too large after instancing: at most " + std::to_string(limits::triangles) +
                       " triangles and " + std::to_string(limits::vertices) + " vertices");
    }

    void bake(const PlacedNode& placed, int index, const tinygltf::Primitive& primitive) {
        const std::optional<int> position = attribute(primitive, "POSITION");
        const std::uint64_t triangles = triangle_count(primitive.mode, corner_count(primitive));
        tally_.points_and_lines += primitive.mode < TINYGLTF_MODE_TRIANGLES;
        tally_.without_position += !position;
        tally_.tails += primitive.mode == TINYGLTF_MODE_TRIANGLES && corner_count(primitive) % 3 != 0;
        if (!position || triangles == 0) return;
        const Elements& positions = accessors_.elements(*position);
        const Corners corners = unroller_.unroll(primitive, static_cast<std::uint32_t>(positions.count));
        append_part(placed, index, primitive, corners);
        const auto base = static_cast<std::uint32_t>(scene_.vertices.position_world.size());
        append_positions(placed, positions, corners);
        append_triangles(corners, base);
        append_normals(placed, primitive, corners);
        append_uv(primitive, corners);
        append_color(primitive, corners);
    }

    void append_part(const PlacedNode& placed, int index, const tinygltf::Primitive& primitive,
                     const Corners& corners) {
        const tinygltf::Node& node = node_of(placed);
        const int default_material = static_cast<int>(scene_.materials.size()) - 1;
        scene_.parts.push_back({on_one_line(node.name),
                                on_one_line(model_.gltf.meshes[static_cast<std::size_t>(node.mesh)].name),
                                index, static_cast<std::uint32_t>(scene_.triangles.size()),
                                corners.triangle_count(),
                                primitive.material < 0 ? default_material : primitive.material});
    }

    /// Appends what bake(element) gives for each of the elements to bake, in order.
    template <typename T, typename Allocator, typename Bake>
    static void append(std::vector<T, Allocator>& attribute, const Elements& elements, const Corners& corners,
                       const Bake& bake) {
        const std::vector<std::uint32_t>& used = corners.used();
        const std::size_t first = attribute.size();
        attribute.resize(first + element_count(elements, corners));
        in_parallel(first, attribute.size(), [&](std::size_t from, std::size_t to) {
            for (std::size_t at = from; at < to; ++at)
                attribute[at] = bake(used.empty() ? at - first : std::size_t{used[at - first]});
        });
    }

    void append_positions(const PlacedNode& placed, const Elements& positions, const Corners& corners) {
        const glm::dmat3 linear(placed.world_from_node);
        const glm::dvec3 translation(placed.world_from_node[3]);
        Positions& baked = scene_.vertices.position_world;
        const std::size_t first = baked.size();
        append(baked, positions, corners,
               [&](std::size_t i) { return glm::vec3(linear * vec3_at(positions, i) + translation); });
        const float largest = largest_coordinate(std::span(baked.data(), baked.size()).subspan(first));
        tally_.is_huge |= largest > square_overflows;
        if (std::isfinite(largest)) return;
        const auto bad =
            std::find_if(baked.begin() + static_cast<std::ptrdiff_t>(first), baked.end(), is_unbounded);
        const auto at = static_cast<std::size_t>(bad - baked.begin()) - first;
        const std::size_t vertex = corners.used().empty() ? at : corners.used()[at];
        refuse(
            model_.file, "/nodes/" + std::to_string(placed.node),
            "vertex " + std::to_string(vertex) + " overflows float32 in world space; scale the scene down");
    }

    /// And counts those whose area is 0 as far as double can tell. They stay, since ids count them.
    void append_triangles(const Corners& corners, std::uint32_t base) {
        const std::size_t first = scene_.triangles.size();
        scene_.triangles.resize(first + corners.triangle_count());
        std::atomic<std::uint64_t> flat = 0;
        in_parallel(first, scene_.triangles.size(), [&](std::size_t from, std::size_t to) {
            const std::span baked = std::span(scene_.triangles).subspan(from, to - from);
            corners.read(static_cast<std::uint32_t>(from - first), baked);
            std::uint64_t flat_here = 0;
            for (glm::uvec3& triangle : baked) {
                triangle += base;
                flat_here += is_flat(triangle);
            }
            flat += flat_here;
        });
        tally_.flat += flat;
    }

    bool is_flat(const glm::uvec3& t) const {
        const auto corner = [this](std::uint32_t i) { return glm::dvec3(scene_.vertices.position_world[i]); };
        const glm::dvec3 origin = corner(t.x), a = corner(t.y) - origin, b = corner(t.z) - origin;
        // The cross product, of which hardly ever more than one component is asked.
        return a.y * b.z == a.z * b.y && a.z * b.x == a.x * b.z && a.x * b.y == a.y * b.x;
    }

    /// The first vertex of the primitive that was appended last; the attribute is padded up to it.
    template <typename T>
    void pad(std::vector<T>& attribute, std::size_t appended, const T& otherwise) const {
        attribute.resize(scene_.vertices.position_world.size() - appended, otherwise);
    }

    static std::size_t element_count(const Elements& elements, const Corners& corners) {
        return corners.used().empty() ? elements.count : corners.used().size();
    }

    void append_normals(const PlacedNode& placed, const tinygltf::Primitive& primitive,
                        const Corners& corners) {
        const std::optional<int> accessor = attribute(primitive, "NORMAL");
        if (!accessor) return;
        const Elements& elements = accessors_.elements(*accessor);
        const glm::dmat3 world_from_normal = normal_matrix(glm::dmat3(placed.world_from_node));
        pad(scene_.vertices.normal_world, element_count(elements, corners), glm::vec3(0));
        append(scene_.vertices.normal_world, elements, corners, [&](std::size_t i) {
            const glm::dvec3 normal = world_from_normal * vec3_at(elements, i);
            const double length = glm::length(normal);
            const bool has_direction = length > 0 && std::isfinite(length);
            return has_direction ? glm::vec3(normal / length) : glm::vec3(0);
        });
    }

    void append_uv(const tinygltf::Primitive& primitive, const Corners& corners) {
        for (std::size_t set = 0; set < limits::uv_sets; ++set) {
            const std::optional<int> accessor = attribute(primitive, "TEXCOORD_" + std::to_string(set));
            if (!accessor) continue;
            const Elements& elements = accessors_.elements(*accessor);
            if (scene_.vertices.uv.size() <= set) scene_.vertices.uv.resize(set + 1);
            std::vector<glm::vec2>& uv = scene_.vertices.uv[set];
            pad(uv, element_count(elements, corners), glm::vec2(0));
            append(uv, elements, corners, [&](std::size_t i) {
                return glm::vec2(glm::dvec2(component(elements, i, 0), component(elements, i, 1)));
            });
        }
    }

    void append_color(const tinygltf::Primitive& primitive, const Corners& corners) {
        const std::optional<int> accessor = attribute(primitive, "COLOR_0");
        if (!accessor) return;
        const Elements& elements = accessors_.elements(*accessor);
        pad(scene_.vertices.color, element_count(elements, corners), glm::vec4(1));
        append(scene_.vertices.color, elements, corners, [&](std::size_t i) {
            const double alpha = elements.components == 4 ? component(elements, i, 3) : 1;
            return glm::vec4(glm::dvec4(vec3_at(elements, i), alpha));
        });
    }

    void note(std::uint64_t count, const std::string& text) const {
        if (count > 0) scene_.notes.push_back(text + ": " + std::to_string(count));
    }

    void note_tally() const {
        note(tally_.points_and_lines, "primitives of points and lines skipped");
        note(tally_.without_position, "primitives without POSITION skipped");
        note(tally_.tails, "primitives whose last one or two corners make no triangle");
        note(tally_.flat, "triangles without area, kept");
        note(tally_.instancing, "nodes with EXT_mesh_gpu_instancing drawn once only");
        note(tally_.singular, "meshes flattened by a singular transform");
        note(tally_.skinned, "skinned meshes baked at rest, by their own node's transform");
        note(tally_.morphed, "meshes with morph targets baked without them");
        note(model_.gltf.animations.size(), "animations ignored, nodes stand at rest");
        if (tally_.is_huge)
            scene_.notes.push_back("coordinates so large that their squares overflow float32");
        if (scene_.triangles.empty()) scene_.notes.push_back("no triangles: there is nothing to judge");
    }

    const GltfModel& model_;
    Scene& scene_;
    Accessors accessors_;
    Unroller unroller_;
    Tally tally_;
};

}  // namespace

void bake_meshes(const GltfModel& model, const std::vector<PlacedNode>& nodes, Scene& scene) {
    Baker baker(model, scene);
    baker.reserve(nodes);
    for (const PlacedNode& placed : nodes) baker.bake(placed);
    baker.finish();
}

}  // namespace zproof
