/// How frames are compared today, for the table of docs/detection-tables.md. Nothing here decides anything.
#pragma once

#include <filesystem>

#include "frame/frame.h"

namespace zproof {

/// PyTorch3D's tests of its rasterizer: do 99.99 % of the ids agree, and 99.9 % of the depths within 0.001?
/// Two backgrounds agree in depth.
bool passes_pytorch3d(const Frame& candidate, const Frame& reference);

/// A fuzzy compare: is every pixel's id found among the 3 x 3 pixels around it in the reference, and its
/// depth between the least and the greatest there, give or take 0.1 %?
bool passes_fuzzy_window(const Frame& candidate, const Frame& reference);

/// idiff's options -fail and -failpercent, at their defaults.
struct IdiffOptions {
    float fail = 1e-6f;
    double fail_percent = 0;
};

/// Blender's render tests: -fail 0.016 -failpercent 1.
inline constexpr IdiffOptions blenders_idiff{.fail = 0.016f, .fail_percent = 1};

/// What OpenImageIO's idiff says of both the picture with a colour per id and the depths, by the comparison
/// that it is made of.
bool passes_idiff(const IdiffOptions& options, const Frame& candidate, const Frame& reference);

/// STEM-id.png, a colour per id, and STEM-depth.exr, one channel Z of float32: what
/// the program idiff is given.
void write_for_idiff(const std::filesystem::path& stem, const Frame& frame);

}  // namespace zproof
