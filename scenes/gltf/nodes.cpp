#include "scenes/gltf/bake.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "scenes/refusal.h"

namespace zproof {
namespace {

glm::dmat4 from_matrix(const GltfModel& model, int node, const std::vector<double>& m) {
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
        refuse(model.file, pointer("nodes", node, "/matrix"),
               "expected the last row 0 0 0 1 (an affine transform); export the file again");
    return {{m[0], m[1], m[2], m[3]},
            {m[4], m[5], m[6], m[7]},
            {m[8], m[9], m[10], m[11]},
            {m[12], m[13], m[14], m[15]}};
}

/// glTF asks for unit quaternions; float32 files hold them to 1e-7 only, so the length is divided out in
/// double.
glm::dmat3 rotation_of(const GltfModel& model, int node, const std::vector<double>& q) {
    const glm::dquat quaternion(q[3], q[0], q[1], q[2]);
    const double length = glm::length(quaternion);
    if (!(length > 0) || !std::isfinite(length))
        refuse(model.file, pointer("nodes", node, "/rotation"),
               "expected a unit quaternion, its length is 0 or overflows; export the file again");
    return glm::mat3_cast(quaternion / length);
}

glm::dmat4 local_transform(const GltfModel& model, int index) {
    const gltf::Node& node = at(model.document.nodes, index);
    if (!node.matrix.empty()) return from_matrix(model, index, node.matrix);
    const std::vector<double>&t = node.translation, &s = node.scale;
    glm::dmat3 linear(1.0);
    if (!node.rotation.empty()) linear = rotation_of(model, index, node.rotation);
    if (!s.empty())
        for (int axis = 0; axis < 3; ++axis) linear[axis] *= s[static_cast<std::size_t>(axis)];
    glm::dmat4 transform(linear);
    if (!t.empty()) transform[3] = {t[0], t[1], t[2], 1};
    return transform;
}

bool is_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

std::vector<int> all_roots(const std::vector<gltf::Node>& nodes) {
    std::vector<bool> is_child(nodes.size(), false);
    for (const gltf::Node& node : nodes)
        for (const int child : node.children) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (!is_child[node]) roots.push_back(static_cast<int>(node));
    return roots;
}

std::vector<int> roots_of(const gltf::Document& document) {
    if (document.scenes.empty()) return all_roots(document.nodes);
    return at(document.scenes, std::max(document.scene, 0)).nodes;
}

}  // namespace

std::vector<PlacedNode> placed_nodes(const GltfModel& model) {
    if (model.document.nodes.empty() && model.document.scenes.empty())
        refuse(model.file, "/scenes", "has neither scenes nor nodes; expected a scene to draw");
    std::vector<PlacedNode> open, placed;
    const auto put = [&](const std::vector<int>& nodes, const glm::dmat4& world_from_parent) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
            open.push_back({*node, world_from_parent});
    };
    put(roots_of(model.document), glm::dmat4(1.0));
    while (!open.empty()) {
        PlacedNode next = open.back();
        open.pop_back();
        next.world_from_node = next.world_from_node * local_transform(model, next.node);
        if (!is_finite(next.world_from_node))
            refuse(model.file, pointer("nodes", next.node),
                   "the world transform overflows; expected finite numbers: scale the scene down");
        placed.push_back(next);
        put(at(model.document.nodes, next.node).children, next.world_from_node);
    }
    return placed;
}

}  // namespace zproof
