#include <string>
#include <vector>

#include "scenes/gltf_check.h"
#include "scenes/gltf_limits.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

std::string node_at(std::size_t node) { return "/nodes/" + std::to_string(node); }

std::vector<bool> nodes_with_a_parent(const Path& file, const json& nodes) {
    std::vector<bool> has_parent(nodes.size(), false);
    for (std::size_t node = 0; node < nodes.size(); ++node)
        for (const std::size_t child : nodes[node].value("children", json::array())) {
            if (has_parent[child]) refuse(file, node_at(child), "has several parents; expected one at most");
            has_parent[child] = true;
        }
    return has_parent;
}

struct Visit {
    std::size_t node = 0, depth = 0;
};

/// Marks root and all that is below it. Terminates, since no node has two parents and the root has none.
void mark_tree(const Path& file, const json& nodes, std::size_t root, std::vector<bool>& is_reached) {
    std::vector<Visit> open{{root, 1}};
    while (!open.empty()) {
        const Visit visit = open.back();
        open.pop_back();
        is_reached[visit.node] = true;
        if (visit.depth > limits::node_depth)
            refuse(file, node_at(visit.node), "nested too deep: at most " + std::to_string(limits::node_depth) + " nodes");
        for (const std::size_t child : nodes[visit.node].value("children", json::array()))
            open.push_back({child, visit.depth + 1});
    }
}

void check_scene_roots(const Path& file, const json& gltf, const std::vector<bool>& has_parent) {
    const json& scenes = gltf["scenes"];
    for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
        std::vector<bool> is_listed(has_parent.size(), false);
        for (const std::size_t node : scenes[scene].value("nodes", json::array())) {
            const std::string place = "/scenes/" + std::to_string(scene) + "/nodes";
            if (has_parent[node]) refuse(file, place, "node " + std::to_string(node) + " is not a root");
            if (is_listed[node]) refuse(file, place, "node " + std::to_string(node) + " is listed twice");
            is_listed[node] = true;
        }
    }
}

}  // namespace

void check_nodes(const Path& file, const json& gltf) {
    if (!gltf.contains("nodes")) return;
    const json& nodes = gltf["nodes"];
    const std::vector<bool> has_parent = nodes_with_a_parent(file, nodes);
    std::vector<bool> is_reached(nodes.size(), false);
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (!has_parent[node]) mark_tree(file, nodes, node, is_reached);
    for (std::size_t node = 0; node < nodes.size(); ++node)
        if (!is_reached[node]) refuse(file, node_at(node), "is its own ancestor; expected a tree");
    if (gltf.contains("scenes")) check_scene_roots(file, gltf, has_parent);
}

}  // namespace zproof
