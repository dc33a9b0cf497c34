/// Planes of 32-bit values as OpenEXR files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

#include "frame/plane.h"

namespace zproof {

/// The types of 32 bits that OpenEXR has, by its numbers.
enum class ExrType : std::uint32_t { uint32 = 0, float32 = 2 };

/// A channel and where its values lie: row-major, `stride` bytes from one pixel to the next.
struct ExrChannel {
    std::string_view name;
    ExrType type = ExrType::float32;
    const void* first = nullptr;
    std::size_t stride = 4;
};

/// Writes a scanline file whole, put together by OpenEXR's own library out of zip-compressed blocks of 16
/// rows (openexr.com, "OpenEXR File Layout"), which are made side by side on the threads of the surrounding
/// tbb::task_arena. Values are copied bit for bit. Channels stand in ascending order of their names. Throws
/// FrameError, naming the file, for a size that Resolution does not allow, where OpenEXR refuses, and where
/// it cannot be written.
void write_exr(const std::filesystem::path& file, Resolution size, std::span<const ExrChannel> channels);

}  // namespace zproof
