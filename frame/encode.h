/// Image formats as bytes in memory, by OpenImageIO's writers.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <string>
#include <vector>

#include "frame/plane.h"

namespace zproof {

struct Encoding {
    std::string format;    ///< OpenImageIO's name of the writer: "openexr", "png"
    OIIO::ImageSpec spec;  ///< size, channels and their types
};

/// `pixels` are row-major and interleaved in the spec's own channel types; no value is converted. `place` is
/// the file or purpose that errors name. Throws FrameError where the size is not one that Resolution allows
/// or the writer refuses.
std::vector<std::byte> encode(const Encoding& encoding, const void* pixels, const std::string& place);

/// Throws FrameError where `size` is outside 1 to 32768 on either side.
void refuse_bad_size(Resolution size, const std::string& place);

}  // namespace zproof
