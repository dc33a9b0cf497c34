/// The one place where a frame that somebody else made is read.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "frame/convention.h"
#include "frame/frame.h"
#include "frame/picture.h"
#include "frame/plane.h"
#include "image_io/image_io.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// For which a frame is read where nobody says otherwise.
inline constexpr std::chrono::minutes usual_read_limit{10};

/// Reads a frame of `view` in the convention of whoever made it. Depths become camera depths, in double, and
/// are rounded to float32 once. A pixel is background where its id says so, or its depth where the convention
/// leaves it to the depth, or the frame has no ids; nothing else is repaired. Files are read in a process of
/// their own, in memory for a frame of this size: throws FrameError where that crashes or is not done in
/// time, where the file is not as declared, and where it has another size than the view.
Frame read_stored_frame(const std::filesystem::path& file, const Convention& convention, const View& view,
                        IdChannel ids = IdChannel::present,
                        std::chrono::milliseconds time_limit = usual_read_limit);

/// The size of such a frame, from the headers alone. Throws as read_stored_frame() does.
Resolution stored_frame_size(const std::filesystem::path& file, const Convention& convention,
                             IdChannel ids = IdChannel::present,
                             std::chrono::milliseconds time_limit = usual_read_limit);

/// The names of the channels of such a frame's depths' file, from the headers alone; none where it cannot be
/// read.
std::vector<std::string> stored_frame_channels(const std::filesystem::path& file,
                                               std::chrono::milliseconds time_limit = usual_read_limit);

/// The memory of headers and of the libraries that read them.
inline constexpr std::size_t reader_memory_bytes = std::size_t{256} << 20;

/// Throws FrameError, naming both sizes.
void refuse_other_size(const std::filesystem::path& file, Resolution size, const View& view);

/// Reads R, G and B, half or float32 in linear light or 8-bit sRGB, in a copy of this process
/// (oracle/isolated.h), as it does frames. Throws FrameError where the file cannot be read, is not of the
/// view's size, or uses up the limit.
Picture read_stored_picture(const std::filesystem::path& file, const View& view,
                            std::chrono::milliseconds time_limit);

}  // namespace zproof::oracle
