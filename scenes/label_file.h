/// Labels of triangles from a JSON file (docs/labels.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace zproof {

/// Reads a list with a label for each triangle, [0, 0, 7, ...], or with runs of triangles in order,
/// [{"count": 12, "label": 7}, ...]. Throws SceneError where it has not exactly `triangles` of them.
std::vector<std::uint32_t> read_label_file(const std::filesystem::path& file, std::size_t triangles);

}  // namespace zproof
