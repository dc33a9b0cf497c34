/// Files that are there whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace zproof {

/// Writes the bytes under a temporary name in the same folder and renames it to `file`, so that no reader
/// ever meets a half-written file; a file of that name is replaced. Throws FrameError, and leaves nothing
/// behind, where that fails.
void write_whole_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// All bytes of a file; empty where it cannot be read.
std::string content_of(const std::filesystem::path& file);

}  // namespace zproof
