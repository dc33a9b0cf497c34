#include <algorithm>
#include <string>
#include <vector>

#include "scenes/gltf_check.h"
#include "scenes/gltf_limits.h"
#include "scenes/gltf_schema.h"
#include "scenes/refusal.h"

namespace zproof {
namespace {

using nlohmann::json;
using Path = std::filesystem::path;

std::string node_at(std::size_t node) { return "/nodes/" + std::to_string(node); }

std::vector<std::size_t> children_of(const json& node) {
    return node.value("children", std::vector<std::size_t>());
}

std::vector<std::size_t> parent_counts(const json& nodes) {
    std::vector<std::size_t> parents(nodes.size(), 0);
    for (const json& node : nodes)
        for (const std::size_t child : children_of(node)) ++parents[child];
    return parents;
}

/// A node's place in the graph: the longest way down to it, and how many ways lead there (how often it is
/// drawn).
struct PathCount {
    std::size_t depth = 1;
    std::uint64_t ways = 1;
};

/// Visits every node after all its parents (Kahn 1962); the number of ways is summed up, never enumerated.
class GraphTraversal {
  public:
    GraphTraversal(const Path& file, const json& nodes)
        : file_(file), nodes_(nodes), waiting_for_(parent_counts(nodes)), path_counts_(nodes.size()) {}

    void run() {
        for (std::size_t node = 0; node < nodes_.size(); ++node)
            if (waiting_for_[node] == 0) open_.push_back(node);
        for (const std::size_t root : open_) placed_ += path_counts_[root].ways;
        while (!open_.empty()) {
            const std::size_t node = open_.back();
            open_.pop_back();
            for (const std::size_t child : children_of(nodes_[node])) add_paths(node, child);
        }
        for (std::size_t node = 0; node < nodes_.size(); ++node)
            if (waiting_for_[node] != 0) refuse(file_, node_at(node), "is its own ancestor; expected a tree");
    }

  private:
    void add_paths(std::size_t node, std::size_t child) {
        PathCount& paths = path_counts_[child];
        const std::uint64_t ways_so_far = is_reached(child) ? paths.ways : 0;
        paths = {std::max(paths.depth, path_counts_[node].depth + 1), ways_so_far + path_counts_[node].ways};
        placed_ += path_counts_[node].ways;
        if (paths.depth > limits::node_depth)
            refuse(file_, node_at(child),
                   "nested too deep: at most " + std::to_string(limits::node_depth) + " nodes");
        if (placed_ > limits::placed_nodes)
            refuse(file_, node_at(child),
                   "nodes with several parents draw more than " + std::to_string(limits::placed_nodes) +
                       " nodes; expected a tree");
        if (--waiting_for_[child] == 0) open_.push_back(child);
    }

    bool is_reached(std::size_t node) const { return path_counts_[node].depth > 1; }

    const Path& file_;
    const json& nodes_;
    std::vector<std::size_t> waiting_for_;  ///< parents that were not visited yet
    std::vector<PathCount> path_counts_;
    std::vector<std::size_t> open_;
    std::uint64_t placed_ = 0;
};

void check_scene_roots(const Path& file, const json& gltf, const std::vector<std::size_t>& parents) {
    const json& scenes = list_of(gltf, "scenes");
    for (std::size_t scene = 0; scene < scenes.size(); ++scene) {
        std::vector<bool> is_listed(parents.size(), false);
        for (const std::size_t node : scenes[scene].value("nodes", std::vector<std::size_t>())) {
            const std::string place = "/scenes/" + std::to_string(scene) + "/nodes";
            if (parents[node] > 0)
                refuse(file, place, "node " + std::to_string(node) + " has a parent; expected roots");
            if (is_listed[node]) refuse(file, place, "node " + std::to_string(node) + " is listed twice");
            is_listed[node] = true;
        }
    }
}

}  // namespace

std::vector<std::string> check_nodes(const Path& file, const json& gltf) {
    const json& nodes = list_of(gltf, "nodes");
    GraphTraversal(file, nodes).run();
    const std::vector<std::size_t> parents = parent_counts(nodes);
    check_scene_roots(file, gltf, parents);
    const auto shared = std::ranges::count_if(parents, [](std::size_t count) { return count > 1; });
    if (shared == 0) return {};
    return {"nodes with several parents, against glTF's rules, drawn once for each: " +
            std::to_string(shared)};
}

}  // namespace zproof
