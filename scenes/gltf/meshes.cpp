#include "scenes/gltf/bake.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <deque>
#include <optional>
#include <span>
#include <string>

#include "math/bulk.h"
#include "scenes/batch.h"
#include "scenes/flat_triangles.h"
#include "scenes/gltf/accessor.h"
#include "scenes/largest.h"
#include "scenes/limits.h"
#include "scenes/polygon_mesh.h"
#include "scenes/refusal.h"
#include "scenes/vector_block.h"

namespace zproof {
namespace {

/// Coordinates beyond this are noted: their squares overflow float32, though they themselves do not.
constexpr double square_overflows = 1.8e19;

struct Tally {
    std::uint64_t points_and_lines = 0, without_position = 0, tails = 0, singular = 0, skinned = 0,
                  unmorphed = 0;
    std::uint64_t instancing = 0;
    std::atomic<std::uint64_t> flat = 0, normals_not_finite = 0, colors_not_finite = 0;
    std::atomic<bool> is_huge = false, is_unbounded = false;
};

/// Inverse transpose up to a positive factor, without a division: cofactors, turned round where the
/// determinant is negative.
glm::dmat3 normal_matrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

std::optional<int> attribute(const gltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? std::nullopt : std::optional(found->second);
}

bool is_unbounded(const glm::vec3& p) {
    return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z);
}

/// The bits of the largest absolute coordinate.
std::uint32_t largest_coordinate(std::span<const glm::vec3> positions) {
    return largest(reinterpret_cast<const unsigned char*>(positions.data()), 3 * positions.size(),
                   magnitude_bits);
}

static_assert(Batch::range_elements <= VectorBlock::capacity);

/// The triangles and vertices that one primitive at one node became.
struct BakedPrimitive {
    int node = 0;
    std::size_t first_vertex = 0, first_triangle = 0, vertex_count = 0;
    Corners corners;

    /// The element of the primitive's accessors that its i-th vertex is.
    std::size_t element(std::size_t i) const { return corners.used().empty() ? i : corners.used()[i]; }
};

class Baker {
  public:
    Baker(const GltfModel& model, Scene& scene)
        : model_(model), scene_(scene), accessors_(model), unroller_(model, accessors_) {}

    void reserve(const std::vector<PlacedNode>& nodes) {
        std::uint64_t triangles = 0, vertices = 0;
        for (const PlacedNode& placed : nodes)
            for (const gltf::Primitive& primitive : primitives_of(placed)) {
                const std::uint64_t corners = corner_count(primitive);
                triangles += triangle_count(primitive.mode, corners);
                vertices += std::min(corners, vertex_count(primitive));
                check_limits(triangles, vertices);
            }
        scene_.triangles.reserve(triangles);
        scene_.vertices.position_world.reserve(vertices);
        scene_.vertices.uv.reserve(limits::uv_sets);
    }

    void bake(const PlacedNode& placed) {
        const gltf::Node& node = node_of(placed);
        if (node.mesh < 0) return;
        tally_.instancing += node.extensions.contains("EXT_mesh_gpu_instancing");
        const std::vector<gltf::Primitive>& primitives = primitives_of(placed);
        for (std::size_t i = 0; i < primitives.size(); ++i) bake(placed, static_cast<int>(i), primitives[i]);
        tally_.singular += glm::determinant(glm::dmat3(placed.world_from_node)) == 0;
        tally_.skinned += node.skin >= 0;
    }

    /// Writes what was made room for, pads attributes that the last primitives lack, and says what was left
    /// out.
    void finish() {
        of_vertices_.run();
        if (tally_.is_unbounded) refuse_unbounded();
        of_triangles_.run();
        Vertices& vertices = scene_.vertices;
        const std::size_t size = vertices.position_world.size();
        if (!vertices.normal_world.empty()) vertices.normal_world.resize(size, glm::vec3(0));
        for (auto& set : vertices.uv) set.resize(size, glm::vec2(0));
        if (!vertices.color.empty()) vertices.color.resize(size, glm::vec4(1));
        note_tally();
    }

  private:
    const gltf::Node& node_of(const PlacedNode& placed) const {
        return at(model_.document.nodes, placed.node);
    }

    const std::vector<gltf::Primitive>& primitives_of(const PlacedNode& placed) const {
        static const std::vector<gltf::Primitive> none;
        const int mesh = node_of(placed).mesh;
        return mesh < 0 ? none : at(model_.document.meshes, mesh).primitives;
    }

    std::uint64_t vertex_count(const gltf::Primitive& primitive) const {
        const std::optional<int> position = attribute(primitive, "POSITION");
        return position ? at(model_.document.accessors, *position).count : 0;
    }

    std::uint64_t corner_count(const gltf::Primitive& primitive) const {
        if (primitive.indices < 0 || !attribute(primitive, "POSITION")) return vertex_count(primitive);
        return at(model_.document.accessors, primitive.indices).count;
    }

    void check_limits(std::uint64_t triangles, std::uint64_t vertices) const {
        if (triangles > limits::triangles || vertices > limits::vertices)
            refuse(model_.file, "scene",
                   "too large after instancing: more than " + std::to_string(limits::triangles) +
                       " triangles or " + std::to_string(limits::vertices) + " vertices; split the scene");
    }

    void bake(const PlacedNode& placed, int index, const gltf::Primitive& primitive) {
        const std::optional<int> position = attribute(primitive, "POSITION");
        const std::uint64_t triangles = triangle_count(primitive.mode, corner_count(primitive));
        tally_.points_and_lines += primitive.mode < TINYGLTF_MODE_TRIANGLES;
        tally_.without_position += !position;
        tally_.tails += primitive.mode == TINYGLTF_MODE_TRIANGLES && corner_count(primitive) % 3 != 0;
        if (!position || triangles == 0) return;
        const Elements& positions = accessors_.elements(*position);
        BakedPrimitive& baked_primitive = baked_primitives_.emplace_back();
        baked_primitive.node = placed.node;
        baked_primitive.corners = unroller_.unroll(primitive, static_cast<std::uint32_t>(positions.count));
        const std::vector<std::uint32_t>& used = baked_primitive.corners.used();
        baked_primitive.vertex_count = used.empty() ? positions.count : used.size();
        append_part(placed, index, primitive, baked_primitive.corners);
        append_positions(placed, positions, displacements_of(placed, primitive, "POSITION", positions),
                         baked_primitive);
        append_triangles(baked_primitive);
        append_normals(placed, primitive, baked_primitive);
        append_uv(primitive, baked_primitive);
        append_color(primitive, baked_primitive);
        tally_.unmorphed +=
            std::size_t(std::ranges::count_if(targets_of(placed, primitive), displaces_no_vector));
    }

    void append_part(const PlacedNode& placed, int index, const gltf::Primitive& primitive,
                     const Corners& corners) {
        const gltf::Node& node = node_of(placed);
        const int default_material = static_cast<int>(scene_.materials.size()) - 1;
        scene_.parts.push_back({on_one_line(node.name),
                                on_one_line(at(model_.document.meshes, node.mesh).name), index,
                                static_cast<std::uint32_t>(scene_.triangles.size()), corners.triangle_count(),
                                primitive.material < 0 ? default_material : primitive.material, placed.node});
    }

    /// Makes room for the vertices of the placement. Vertices before it that lack the attribute get
    /// `otherwise`.
    template <typename T>
    void make_room(Bulk<T>& attribute, const BakedPrimitive& baked_primitive, const T& otherwise) const {
        attribute.reserve(scene_.vertices.position_world.capacity());
        attribute.resize(baked_primitive.first_vertex, otherwise);
        attribute.resize(baked_primitive.first_vertex + baked_primitive.vertex_count);
    }

    /// Makes room, and has bake(element) written there for each vertex later.
    template <typename T, typename Bake>
    void append(Bulk<T>& attribute, const BakedPrimitive& baked_primitive, const T& otherwise,
                const Bake& bake) {
        make_room(attribute, baked_primitive, otherwise);
        of_vertices_.add(baked_primitive.vertex_count,
                         [&attribute, &baked_primitive, bake](std::size_t i, std::size_t end) {
                             for (T* to = &attribute[baked_primitive.first_vertex]; i < end; ++i)
                                 to[i] = bake(baked_primitive.element(i));
                         });
    }

    /// A morph target, or an attribute of it, and what it is multiplied by.
    template <typename T>
    struct Weighted {
        double weight = 0;
        const T* of = nullptr;
    };
    using Target = std::map<std::string, int>;
    using Displacements = std::vector<Weighted<Elements>>;

    /// The targets that count: the weights are the node's, else the mesh's; animations are not played.
    std::vector<Weighted<Target>> targets_of(const PlacedNode& placed,
                                             const gltf::Primitive& primitive) const {
        const gltf::Node& node = node_of(placed);
        const std::vector<double>& weights =
            node.weights.empty() ? at(model_.document.meshes, node.mesh).weights : node.weights;
        std::vector<Weighted<Target>> targets;
        for (std::size_t i = 0; i < std::min(weights.size(), primitive.targets.size()); ++i)
            if (weights[i] != 0) targets.push_back({weights[i], &primitive.targets[i]});
        return targets;
    }

    /// What is added to an attribute that is a vector. An accessor without data holds zeros.
    Displacements displacements_of(const PlacedNode& placed, const gltf::Primitive& primitive,
                                   const std::string& name, const Elements& base) {
        Displacements displacements;
        for (const auto& [weight, target] : targets_of(placed, primitive)) {
            const auto found = target->find(name);
            if (found == target->end()) continue;
            const gltf::Accessor& declared = at(model_.document.accessors, found->second);
            if (declared.type != "VEC3" || declared.count != base.count)
                refuse(model_.file, pointer("accessors", found->second),
                       "a morph target's " + name + ": expected " + std::to_string(base.count) +
                           " VEC3, as many as the primitive has; export the file again");
            if (declared.bufferView >= 0 || declared.sparse.count > 0)
                displacements.push_back({weight, &accessors_.elements(found->second)});
        }
        return displacements;
    }

    static bool displaces_no_vector(const Weighted<Target>& target) {
        return std::ranges::any_of(*target.of, [](const auto& attribute) {
            return attribute.first.starts_with("TEXCOORD_") || attribute.first.starts_with("COLOR_");
        });
    }

    /// The vectors of a range of the placement's vertices, displaced.
    static VectorBlock block_of(const Elements& elements, const Displacements& displacements,
                                const BakedPrimitive& baked_primitive, std::size_t from, std::size_t end) {
        VectorBlock block = block_of(elements, baked_primitive, from, end);
        for (const auto& [weight, displacement] : displacements)
            block.add(weight, block_of(*displacement, baked_primitive, from, end));
        return block;
    }

    /// The vectors of a range of the placement's vertices.
    static VectorBlock block_of(const Elements& elements, const BakedPrimitive& baked_primitive,
                                std::size_t from, std::size_t end) {
        VectorBlock block(end - from);
        if (elements.component_type == component_type_float && elements.stride == sizeof(glm::vec3) &&
            baked_primitive.corners.used().empty()) {
            block.read(elements.first + from * sizeof(glm::vec3));
            return block;
        }
        for (std::size_t i = from; i < end; ++i)
            block.set(i - from, vec3_at(elements, baked_primitive.element(i)));
        return block;
    }

    void append_positions(const PlacedNode& placed, const Elements& positions, Displacements displacements,
                          BakedPrimitive& baked_primitive) {
        baked_primitive.first_vertex = scene_.vertices.position_world.size();
        scene_.vertices.position_world.resize(baked_primitive.first_vertex + baked_primitive.vertex_count);
        of_vertices_.add(baked_primitive.vertex_count, [&, world_from_node = placed.world_from_node,
                                                        displacements = std::move(displacements)](
                                                           std::size_t from, std::size_t end) {
            const std::span baked = std::span(scene_.vertices.position_world)
                                        .subspan(baked_primitive.first_vertex + from, end - from);
            VectorBlock block = block_of(positions, displacements, baked_primitive, from, end);
            block.multiply(glm::dmat3(world_from_node));
            block.add(glm::dvec3(world_from_node[3]));
            block.write(baked);
            tally_magnitude(largest_coordinate(baked));
        });
    }

    void tally_magnitude(std::uint32_t largest) {
        if (largest >= infinite_bits)
            tally_.is_unbounded = true;
        else if (std::bit_cast<float>(largest) > square_overflows)
            tally_.is_huge = true;
    }

    void refuse_unbounded() const {
        const Positions& baked = scene_.vertices.position_world;
        const auto bad = static_cast<std::size_t>(std::ranges::find_if(baked, is_unbounded) - baked.begin());
        const auto baked_primitive = std::ranges::find_if(baked_primitives_, [&](const BakedPrimitive& p) {
            return bad < p.first_vertex + p.vertex_count;
        });
        refuse(model_.file, "/nodes/" + std::to_string(baked_primitive->node),
               "vertex " + std::to_string(baked_primitive->element(bad - baked_primitive->first_vertex)) +
                   " overflows float32 in world space; scale the scene down");
    }

    /// Triangles without area stay, since ids count them.
    void append_triangles(BakedPrimitive& baked_primitive) {
        baked_primitive.first_triangle = scene_.triangles.size();
        scene_.triangles.resize(baked_primitive.first_triangle + baked_primitive.corners.triangle_count());
        of_triangles_.add(baked_primitive.corners.triangle_count(), [&baked_primitive, this](
                                                                        std::size_t from, std::size_t end) {
            const std::span baked =
                std::span(scene_.triangles).subspan(baked_primitive.first_triangle + from, end - from);
            baked_primitive.corners.read(static_cast<std::uint32_t>(from), baked);
            for (glm::uvec3& triangle : baked)
                triangle += static_cast<std::uint32_t>(baked_primitive.first_vertex);
            tally_.flat += flat_among(baked, scene_.vertices.position_world);
        });
    }

    void append_normals(const PlacedNode& placed, const gltf::Primitive& primitive,
                        const BakedPrimitive& baked_primitive) {
        const std::optional<int> accessor = attribute(primitive, "NORMAL");
        if (!accessor) return;
        const glm::dmat3 world_from_normal = normal_matrix(glm::dmat3(placed.world_from_node));
        const Elements& elements = accessors_.unchecked(*accessor);
        const auto displacements = displacements_of(placed, primitive, "NORMAL", elements);
        const bool all_finite = accessors_.is_finite(*accessor);
        make_room(scene_.vertices.normal_world, baked_primitive, glm::vec3(0));
        of_vertices_.add(baked_primitive.vertex_count, [=, this, &elements, &baked_primitive](
                                                           std::size_t from, std::size_t end) {
            VectorBlock block = block_of(elements, displacements, baked_primitive, from, end);
            block.multiply(world_from_normal);
            block.normalize();
            const std::span baked = std::span(scene_.vertices.normal_world)
                                        .subspan(baked_primitive.first_vertex + from, end - from);
            block.write(baked);
            for (std::size_t i = from; !all_finite && i < end; ++i) {
                if (!is_unbounded(glm::vec3(vec3_at(elements, baked_primitive.element(i))))) continue;
                baked[i - from] = glm::vec3(0);
                ++tally_.normals_not_finite;
            }
        });
    }

    void append_uv(const gltf::Primitive& primitive, const BakedPrimitive& baked_primitive) {
        for (std::size_t set = 0; set < limits::uv_sets; ++set) {
            const std::optional<int> accessor = attribute(primitive, "TEXCOORD_" + std::to_string(set));
            if (!accessor) continue;
            if (scene_.vertices.uv.size() <= set) scene_.vertices.uv.resize(set + 1);
            append(scene_.vertices.uv[set], baked_primitive, glm::vec2(0),
                   [&elements = accessors_.elements(*accessor)](std::size_t i) {
                       return glm::vec2(vec2_at(elements, i));
                   });
        }
    }

    void append_color(const gltf::Primitive& primitive, const BakedPrimitive& baked_primitive) {
        const std::optional<int> accessor = attribute(primitive, "COLOR_0");
        if (!accessor) return;
        append(scene_.vertices.color, baked_primitive, glm::vec4(1),
               [this, &elements = accessors_.unchecked(*accessor)](std::size_t i) {
                   const double alpha = elements.components == 4 ? component(elements, i, 3) : 1;
                   const glm::vec4 color{glm::dvec4(vec3_at(elements, i), alpha)};
                   if (std::isfinite(alpha) && !is_unbounded(glm::vec3(color))) return color;
                   ++tally_.colors_not_finite;
                   return glm::vec4(1);
               });
    }

    void note(std::uint64_t count, const std::string& text) const { note_count(scene_, count, text); }

    void note_tally() const {
        note(tally_.points_and_lines, "primitives of points and lines skipped");
        note(tally_.without_position, "primitives without POSITION skipped");
        note(tally_.tails, "primitives whose last one or two corners make no triangle");
        note(tally_.flat, "triangles without area, kept");
        note(tally_.normals_not_finite, "vertices whose NORMAL is not finite, read as without one");
        note(tally_.colors_not_finite, "vertices whose COLOR_0 is not finite, read as white");
        note(tally_.instancing, "nodes with EXT_mesh_gpu_instancing drawn once only");
        note(tally_.singular, "meshes flattened by a singular transform");
        note(tally_.skinned, "skinned meshes baked at rest, by their own node's transform");
        note(tally_.unmorphed, "morph targets of TEXCOORD and COLOR not applied");
        note(model_.animations, "animations ignored, nodes stand at rest");
        if (tally_.is_huge)
            scene_.notes.push_back("coordinates so large that their squares overflow float32");
        if (scene_.triangles.empty()) scene_.notes.push_back("no triangles: there is nothing to judge");
    }

    const GltfModel& model_;
    Scene& scene_;
    Accessors accessors_;
    Unroller unroller_;
    std::deque<BakedPrimitive> baked_primitives_;  ///< in the order of their vertices and triangles
    Batch of_vertices_, of_triangles_;             ///< triangles are measured by the vertices
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
