#include "scenes/triangle_labels.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "scenes/cryptomatte.h"
#include "scenes/label_file.h"

namespace zproof {
namespace {

/// A part's label, and the name that it is known by; empty: none.
struct PartLabel {
    std::uint32_t label;
    std::string name;
};

const std::string& material_name(const Scene& scene, const Part& part) {
    return scene.materials.at(std::size_t(part.material)).name;
}

PartLabel by_hash(const std::string& name) { return {cryptomatte_id(name), name}; }

/// A word for labels that the scene itself knows.
struct Kind {
    const char* word;
    /// `primitive`: the part's index among those that have triangles.
    PartLabel (*label)(const Scene& scene, const Part& part, std::uint32_t primitive);
    bool is_hash = false;
};

constexpr std::array kinds{
    Kind{"primitive",
         [](const Scene&, const Part& part, std::uint32_t primitive) {
             return PartLabel{primitive, part.node};
         }},
    Kind{"node",
         [](const Scene&, const Part& part, std::uint32_t) {
             return PartLabel{std::uint32_t(part.node_index), part.node};
         }},
    Kind{"material",
         [](const Scene& scene, const Part& part, std::uint32_t) {
             return PartLabel{std::uint32_t(part.material), material_name(scene, part)};
         }},
    Kind{"cryptomatte-object",
         [](const Scene&, const Part& part, std::uint32_t) { return by_hash(part.node); }, true},
    Kind{"cryptomatte-material",
         [](const Scene& scene, const Part& part, std::uint32_t) {
             return by_hash(material_name(scene, part));
         },
         true},
};

TriangleLabels labels_by(const Kind& kind, const Scene& scene) {
    TriangleLabels labels{.ids = kind.word,
                          .of_triangle = std::vector<std::uint32_t>(scene.triangles.size())};
    if (kind.is_hash) labels.background.push_back(0);
    std::uint32_t primitive = 0;
    for (const Part& part : scene.parts) {
        if (part.triangle_count == 0) continue;
        const auto [label, name] = kind.label(scene, part, primitive++);
        std::fill_n(labels.of_triangle.begin() + part.first_triangle, part.triangle_count, label);
        if (!name.empty()) labels.names.emplace(label, name);
    }
    return labels;
}

}  // namespace

const std::vector<std::string>& label_words() {
    static const std::vector<std::string> words = [] {
        std::vector<std::string> all{"triangle", "none"};
        for (const Kind& kind : kinds) all.emplace_back(kind.word);
        return all;
    }();
    return words;
}

TriangleLabels label_triangles(const std::string& word, const Scene& scene) {
    if (word == "none")
        return {.ids = word,
                .of_triangle = std::vector<std::uint32_t>(scene.triangles.size()),
                .are_absent = true};
    const auto kind = std::ranges::find_if(kinds, [&](const Kind& k) { return k.word == word; });
    if (kind != kinds.end()) return labels_by(*kind, scene);
    return {.ids = word, .of_triangle = read_label_file(word, scene.triangles.size())};
}

}  // namespace zproof
