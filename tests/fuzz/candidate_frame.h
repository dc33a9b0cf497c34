/// A candidate's frame of 4 x 3 pixels, read in this process: oracle/convention/stored_frame.h does the same
/// in a copy of it, where a crash would not be seen.
#pragma once

#include "frame/convention_presets.h"
#include "frame/convention_text.h"
#include "frame/frame_error.h"
#include "image_io/image_io.h"
#include "image_io/raw_frame.h"
#include "scenes/camera_depth.h"
#include "tests/fuzz/image_module.h"
#include "tests/fuzz/scratch_folder.h"

namespace zproof::fuzz {

/// The convention that a number chooses: ours, or a preset.
inline Convention convention_numbered(std::size_t number) {
    const auto presets = convention_presets();
    const std::size_t chosen = number % (presets.size() + 1);
    return chosen == 0 ? Convention{} : convention_from_words(std::string(presets[chosen - 1].name), "");
}

inline void read_candidate_frame(const std::filesystem::path& file, const Convention& convention) {
    View view;
    view.width = 4;
    view.height = 3;
    if (convention == Convention{}) {
        if (frame_size(file) == Resolution{4, 3}) read_frame(file);
        return;
    }
    if (raw_frame_size(file, convention) != Resolution{4, 3}) return;
    const RawFrame raw = read_raw_frame(file, convention);
    const CameraDepth camera_depth(convention, view);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) camera_depth(raw.stored_depth.at(x, y), x, y);
}

}  // namespace zproof::fuzz
