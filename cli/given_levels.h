/// The levels of a mip chain that a user brings along.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "texture/linear_image.h"

namespace zproof {

/// Levels 1, 2 and on from files, up to the first that there is not; {level} in the name stands for the
/// number. An .exr is linear light, anything else 8-bit sRGB. Null where the name has no {level}, or no file
/// of level 1 exists. Throws what the reading of an image throws.
std::shared_ptr<const std::vector<texture::LinearImage>> given_levels(const std::string& name);

}  // namespace zproof
