/// How frames are compared today, for the table of docs/detection.md. None of this decides anything here.
#pragma once

#include <filesystem>

#include "frame/frame.h"

namespace zproof {

/// PyTorch3D's tests of its rasterizer: do 99.99 % of the ids agree, and 99.9 % of the depths within 0.001?
/// Two backgrounds agree in depth.
bool passes_pytorch3d(const Frame& candidate, const Frame& reference);

/// A fuzzy compare: is every pixel's id found within the 3 x 3 pixels around it in the reference, there with
/// a depth that is the same within 0.1 %?
bool passes_fuzzy_window(const Frame& candidate, const Frame& reference);

/// STEM-id.png, a colour per id, and STEM-depth.exr, one channel Z of float32: what idiff is given.
void write_for_idiff(const std::filesystem::path& stem, const Frame& frame);

}  // namespace zproof
