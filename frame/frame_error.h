#pragma once

#include <stdexcept>

namespace zproof {

/// A frame could not be read or written: names the file, the channel or place, and what was expected.
struct FrameError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace zproof
