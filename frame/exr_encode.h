/// Planes of 32-bit values as OpenEXR files in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
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

/// A scanline file, put together by OpenEXR's own library out of zip-compressed blocks of 16 rows
/// (openexr.com, "OpenEXR File Layout"), which are made side by side on the threads of the surrounding
/// tbb::task_arena. Values are copied bit for bit. Channels
/// stand in ascending order of their names. Throws FrameError, naming `place`, for a size that Resolution
/// does not allow, and where OpenEXR refuses.
std::string encode_exr(Resolution size, std::span<const ExrChannel> channels, const std::string& place);

}  // namespace zproof
