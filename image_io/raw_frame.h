/// A frame in somebody's own convention, as far as it can be read without the camera.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "frame/convention.h"
#include "frame/frame.h"

namespace zproof {

struct RawFrame {
    /// Ids of the scene's triangles; nothing where the file has no channel for them.
    std::optional<Plane<PrimitiveId>> primitive;
    std::string why_no_ids;      ///< the complaint about the missing channel
    Plane<double> stored_depth;  ///< as stored, before any scale; row 0 at the top
    Attributes attributes;       ///< those that the file has
};

/// Reads the channels that the convention names from an image that read_frame() takes, a 16-bit PNG or an
/// .npy file, or from two of them, "IDS+DEPTHS". Where the file has no data, there is background. Throws
/// FrameError where a channel is not as declared, and for an id that is not exact or is no triangle's number.
RawFrame read_raw_frame(const std::filesystem::path& file, const Convention& convention);
/// The size of that frame, from the headers alone.
Resolution raw_frame_size(const std::filesystem::path& file, const Convention& convention);

/// The names of all channels of the file that has the depths, and attributes if any. Throws FrameError.
std::vector<std::string> depth_file_channels(const std::filesystem::path& file);

}  // namespace zproof
