/// A frame's pixels, told as another picture's.
#pragma once

#include <functional>

#include "frame/frame.h"

namespace zproof::measure {

struct Pixel {
    int x = 0, y = 0;
};

/// A frame of that size: what stands at each pixel is what `frame` has at from(x, y), its id renamed.
inline Frame mapped_frame(const Frame& frame, Resolution size, const std::function<Pixel(int, int)>& from,
                          const std::function<PrimitiveId(PrimitiveId, Pixel)>& renamed) {
    Frame told(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Pixel p = from(x, y);
            const PrimitiveId id = frame.primitive.at(p.x, p.y);
            told.primitive.at(x, y) = id == PrimitiveId::none ? id : renamed(id, p);
            told.camera_depth.at(x, y) = frame.camera_depth.at(p.x, p.y);
        }
    return told;
}

}  // namespace zproof::measure
