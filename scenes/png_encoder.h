/// Images as PNG in memory, for embedding in a binary glTF.
#pragma once

#include <string>

#include "scenes/scene.h"

namespace zproof {

/// The image as an 8-bit RGBA PNG (W3C PNG, second edition), the same texels, without filters and not
/// interlaced. Throws SceneError where width and height are not positive or do not fit the texels.
std::string encode_png(const Image& image);

}  // namespace zproof
