/// Frames as OpenEXR: channels `id` (uint32) and `Z` (float32), bit for bit; and pictures.
#pragma once

#include <filesystem>

#include "frame/frame.h"
#include "frame/picture.h"

namespace zproof {

/// Writes both AOVs, zip-compressed. Throws FrameError where the file cannot be written.
void write_exr(const std::filesystem::path& file, const Frame& frame);

/// Reads a frame back. Throws FrameError, naming the file and the channel, where a channel is missing, of
/// another type, or the image is not readable. Values are not judged here: NaN and stray ids pass through.
Frame read_exr(const std::filesystem::path& file);

/// Writes channels R, G, B (float32, linear light), zip-compressed. Throws FrameError as above.
void write_exr(const std::filesystem::path& file, const Picture& picture);

/// Reads a picture back, bit for bit. Throws FrameError as read_exr does.
Picture read_picture_exr(const std::filesystem::path& file);

}  // namespace zproof
