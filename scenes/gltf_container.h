/// The outside of a glTF file: plain JSON, or a GLB with its chunks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "scenes/gltf_files.h"

namespace zproof {

struct Container {
    std::string_view json;  ///< into the bytes that were opened
    bool is_glb = false;
    std::optional<std::uint64_t> bin_bytes;  ///< length of the GLB's BIN chunk, where it has one
};

/// Tells GLB from JSON by its first bytes and checks magic, version, lengths and order of chunks.
/// Throws SceneError, naming the byte, where they contradict the file.
Container open_container(const std::filesystem::path& file, const Bytes& bytes);

}  // namespace zproof
