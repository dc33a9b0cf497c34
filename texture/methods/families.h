/// The families of methods, one file each.
#pragma once

#include "texture/method.h"

namespace zproof::texture {

std::vector<Method> point_methods();  ///< level 0 alone: nearest, bilinear
std::vector<Method> mip_methods();    ///< one place in a mip chain
std::vector<Method> sat_methods();    ///< boxes of a summed-area table

}  // namespace zproof::texture
