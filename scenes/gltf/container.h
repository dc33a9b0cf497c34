/// The outside of a glTF file: plain JSON, or a GLB with its chunks.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "scenes/scene_files.h"

namespace zproof {

/// Views of the bytes that were opened.
struct Container {
    std::string_view json;
    std::span<const unsigned char> bin;  ///< the GLB's BIN chunk, empty where it has none
};

/// Tells GLB from JSON by its first bytes and checks magic, version, lengths and order of chunks.
/// Throws SceneError, naming the byte, where they contradict the file.
Container open_container(const std::filesystem::path& file, const Bytes& bytes);

/// A GLB of the two chunks.
Bytes packed_glb(const Container& container);

}  // namespace zproof
