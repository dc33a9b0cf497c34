/// The colours of ids.
#pragma once

#include <span>

#include "frame/frame.h"
#include "frame/picture.h"

namespace zproof {

inline constexpr Rgb8 background_colour{0x14, 0x16, 0x1A}, no_depth_colour{0xFF, 0x00, 0xFF};

/// A colour per id, the same in every picture; background is dark. As many pixels as ids.
void colour_ids(std::span<const PrimitiveId> ids, std::span<Rgb8> pixels);

}  // namespace zproof
