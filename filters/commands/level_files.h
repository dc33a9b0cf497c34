/// The levels of a mip chain that a user brings along.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "texture/linear_image.h"

namespace zproof {

/// Levels 1, 2 and on. {level} in the name stands for the number: files up to the first that there is not.
/// Without it, the name is that of one file, and its mip levels are meant. Samples of half or float32 are
/// linear light, others sRGB of 8 bits. Null where there is no level 1. Throws FrameError.
std::shared_ptr<const std::vector<texture::LinearImage>> levels_from_files(const std::string& name);

}  // namespace zproof
