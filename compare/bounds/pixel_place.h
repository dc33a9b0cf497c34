/// Places of pixels, and places near them.
#pragma once

namespace zproof {

/// Where a pixel lies in its view.
struct PixelPlace {
    int x = 0, y = 0;

    bool operator==(const PixelPlace&) const = default;
};

/// A place near a pixel: px from its centre, y down.
struct PixelOffset {
    double x = 0, y = 0;
};

}  // namespace zproof
