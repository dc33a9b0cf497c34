/// The sizes that files of frames and pictures may have.
#pragma once

#include <string>

#include "frame/plane.h"

namespace zproof {

/// Throws FrameError, naming the file or purpose `place`, where `size` is outside 1 to 32768 on either side.
void refuse_bad_size(Resolution size, const std::string& place);

}  // namespace zproof
