#pragma once

#include <stdexcept>
#include <string>

#include "frame/plane.h"

namespace zproof {

/// A frame could not be read or written: names the file, the channel or place, and what was expected.
struct FrameError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws FrameError, naming the file or purpose `place`, where `size` is outside 1 to 32768 on either side.
void refuse_bad_size(Resolution size, const std::string& place);

}  // namespace zproof
