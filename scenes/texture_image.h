/// PNG and JPEG images, measured before they are decoded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "scenes/scene.h"

namespace zproof {

/// An image's size as its header states it.
struct ImageExtent {
    enum class Format { png, jpeg } format = Format::png;
    std::uint64_t width = 0, height = 0;
};

/// A reason why the bytes cannot be an image within limits, or nothing. Reads headers only: PNG chunks, JPEG
/// markers.
std::string image_fault(std::span<const unsigned char> bytes);

/// Format and size. The bytes are without fault.
ImageExtent image_extent(std::span<const unsigned char> bytes);

/// Decodes bytes without fault into 8 bit RGBA (16 bit channels are rounded). Throws std::runtime_error with
/// the reason where the data is broken.
Image decode_image(std::span<const unsigned char> bytes);

/// Has that file of OpenEXR or DDS half or float32 samples? Throws FrameError.
bool is_texture_of_floats(const std::filesystem::path& file);

/// A file of OpenEXR or DDS as a texture: floats as linear light, other samples as sRGB codes. Throws
/// FrameError, or std::runtime_error for a texel that is no number.
Image texture_in(const std::filesystem::path& file);

}  // namespace zproof
