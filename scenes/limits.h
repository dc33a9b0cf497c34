/// How much a scene file may ask for. A file beyond a limit is refused before anything is allocated for it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace zproof::limits {

constexpr std::uint64_t file_bytes = std::uint64_t{1} << 30;    ///< each file: scene, buffer or image
constexpr std::uint64_t total_bytes = std::uint64_t{1} << 31;   ///< all files of a scene together
constexpr std::size_t json_depth = 64;                          ///< nested arrays and objects
constexpr std::size_t json_values = std::size_t{1} << 24;       ///< values in one JSON text
constexpr std::size_t json_objects = std::size_t{1} << 21;      ///< each becomes a structure
constexpr std::size_t node_depth = 1024;                        ///< nested nodes
constexpr std::uint64_t placed_nodes = std::uint64_t{1} << 20;  ///< nodes to draw, once per parent
constexpr std::uint64_t triangles = std::uint64_t{1} << 27;     ///< baked, after instancing
constexpr std::uint64_t vertices = std::uint64_t{1} << 28;      ///< baked, after instancing
constexpr std::uint64_t sparse_bytes = std::uint64_t{1}
                                       << 28;  ///< sparse accessors written out, all together
constexpr std::uint64_t decoded_bytes = std::uint64_t{1} << 30;  ///< compressed meshes decoded, all together
constexpr std::uint64_t image_side = 16384;                      ///< texels
constexpr std::uint64_t image_texels = std::uint64_t{1} << 26;   ///< each image
constexpr std::uint64_t all_texels = std::uint64_t{1} << 28;     ///< all images of a scene together
constexpr int jpeg_scans = 256;                                  ///< progressive passes of one JPEG
constexpr std::uint64_t ear_tests = std::uint64_t{1} << 30;      ///< corners squared, of all concave faces
constexpr int uv_sets = 8;                                       ///< TEXCOORD_0 to TEXCOORD_7

/// Integers in JSON beyond this are refused, so that none is cut where an int keeps it, and sums
/// and products of two checked ones fit 64 bits.
constexpr std::uint64_t json_integer = (std::uint64_t{1} << 31) - 1;

}  // namespace zproof::limits
