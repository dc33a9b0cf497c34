/// What the ids of a frame stand for where they are coarser than triangles: one label for each triangle
/// (docs/labels.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace zproof {

struct TriangleLabels {
    std::string ids;                                     ///< the word that asked for them: "material"
    std::vector<std::uint32_t> of_triangle;              ///< as many as the scene has triangles
    std::map<std::uint32_t, std::string> names{};        ///< of labels that have one
    std::vector<std::uint32_t> background{0xFFFF'FFFF};  ///< ids that mean background
    /// Has the frame no ids at all? Then one label stands for every triangle, and depth tells background.
    bool are_absent = false;
    bool is_far_background = false;  ///< of depth alone: does a surface on the far plane read as background?
};

/// The words that label_triangles() knows, "triangle" and "none" among them.
const std::vector<std::string>& label_words();

/// What is wrong with a word that should be one of them or name a file, and what was expected; or nothing.
std::string fault_of_label_word(const std::string& word);

/// The labels that a word stands for: one of label_words() but "triangle", or a file
/// (scenes/triangle_labels.h). Throws SceneError for a file that cannot be read or does not fit the scene.
TriangleLabels label_triangles(const std::string& word, const Scene& scene);

/// Reads a list with a label for each triangle, [0, 0, 7, ...], or with runs of triangles in order,
/// [{"count": 12, "label": 7}, ...]. Throws SceneError where it has not exactly `triangles` of them.
std::vector<std::uint32_t> read_label_file(const std::filesystem::path& file, std::size_t triangles);

}  // namespace zproof
