/// A picture that somebody else's renderer wrote.
#pragma once

#include <chrono>
#include <filesystem>

#include "frame/picture.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// Reads R, G and B, half or float32 and in linear light, in a copy of this process (oracle/isolated.h), as
/// it does frames. Throws FrameError where the file cannot be read, is not of the view's size, or uses up the
/// limit.
Picture read_stored_picture(const std::filesystem::path& file, const View& view,
                            std::chrono::milliseconds time_limit);

}  // namespace zproof::oracle
