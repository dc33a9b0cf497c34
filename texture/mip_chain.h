/// Prefiltered copies of a texture, each half the size of the one before (Williams 1983).
#pragma once

#include "texture/method.h"

namespace zproof::texture {

/// Level 0 is the image; level k + 1 has max(1, floor(size / 2)) texels on either side, down to 1 x 1.
/// Averages are of linear light, summed in double and rounded once to float32.
std::vector<LinearImage> mip_chain(const LinearImage& image, MipKernel kernel);

}  // namespace zproof::texture
