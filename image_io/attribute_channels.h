/// The channels of a frame's attributes (frame/attributes.h).
#pragma once

#include "frame/attributes.h"
#include "image_io/image_file.h"

namespace zproof::image_io {

/// Reads the attributes that an OpenEXR file holds, bit for bit; 0 where it has no data. A channel that
/// several parts have is taken from the part of the depths, if that has it. Throws FrameError where one is
/// not float or of another size than the frame, and where some of an attribute's channels are missing.
Attributes read_attributes(const ImageFile& file, int part_of_depths, Resolution size);

}  // namespace zproof::image_io
