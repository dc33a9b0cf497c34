/// The one place where a frame that somebody else made is read.
#pragma once

#include <filesystem>

#include "frame/convention.h"
#include "frame/frame.h"
#include "image_io/image_io.h"
#include "scenes/view.h"

namespace zproof::oracle {

/// Reads a frame of `view` in the convention of whoever made it. Depths become camera depths, in double, and
/// are rounded to float32 once. A pixel is background where its id says so, or its depth where the convention
/// leaves it to the depth, or the frame has no ids; nothing else is repaired. Throws FrameError where the
/// file is not as declared, and where it has another size than the view.
Frame read_stored_frame(const std::filesystem::path& file, const Convention& convention, const View& view,
                        IdChannel ids = IdChannel::present);

/// The size of such a frame, from the headers alone.
Resolution stored_frame_size(const std::filesystem::path& file, const Convention& convention,
                             IdChannel ids = IdChannel::present);

}  // namespace zproof::oracle
