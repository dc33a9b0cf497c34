/// Pixel coordinates, and offsets from a pixel's centre.
#pragma once

namespace zproof {

/// A pixel's column and row in its view.
struct PixelCoord {
    int x = 0, y = 0;

    bool operator==(const PixelCoord&) const = default;
};

/// An offset from a pixel's centre, px, y down.
struct PixelOffset {
    double x = 0, y = 0;
};

}  // namespace zproof
