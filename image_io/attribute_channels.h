/// The channels of a frame's attributes (frame/attributes.h).
#pragma once

#include "frame/attributes.h"
#include "image_io/image_file.h"

namespace zproof::image_io {

/// Reads the attributes that an OpenEXR file holds, bit for bit; 0 where it has no data. An attribute's
/// channels are named as frame/attributes.h says, or are a layer's (`L.bary.u`). Where several layers have
/// one, the depths' layer is meant, and else the first. A channel that several parts have is taken from the
/// part of the depths, if that has it. Throws FrameError where one is not float or of another size than the
/// frame, and where some of an attribute's channels are missing.
Attributes read_attributes(const ImageFile& file, const ChannelPlace& depths, Resolution size);

}  // namespace zproof::image_io
