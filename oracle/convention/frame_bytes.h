/// A frame on its way from one process to another of the same program.
#pragma once

#include <string>

#include "frame/frame.h"
#include "oracle/isolated.h"

namespace zproof::oracle {

/// The frame's planes, bit for bit.
Bytes bytes_of(const Frame& frame);

/// The frame that they are of. Throws FrameError, which begins with `name`, where bytes are missing.
Frame frame_from(const Bytes& bytes, const std::string& name);

}  // namespace zproof::oracle
