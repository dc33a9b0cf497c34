/// The files that one frame is stored in.
#pragma once

#include <filesystem>

namespace zproof::image_io {

/// The file of the ids and that of the depths, which may be one.
struct FrameFiles {
    std::filesystem::path ids, depths;
};

/// "IDS+DEPTHS" as two files where both are there; else the one file that is named.
FrameFiles frame_files(const std::filesystem::path& named);

}  // namespace zproof::image_io
