/// The header of a PLY file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zproof {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t bytes_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;         ///< of the value, or of each value of a list
    std::optional<PlyType> count_type = {};  ///< of a list's length; none: the property is one value
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties = {};
};

struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian };
    Format format = Format::ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< where the values begin
};

/// Throws SceneError, naming the line, for a header that is not PLY 1.0, or that promises more elements than
/// the file has bytes for.
PlyHeader ply_header(const std::filesystem::path& file, std::string_view content);

}  // namespace zproof
