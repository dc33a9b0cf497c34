/// Small pieces of pictures, magnified so that every pixel is a square.
#pragma once

#include <optional>
#include <string>

#include "frame/picture.h"

namespace zproof {

struct CropBox {
    int x = 0, y = 0, width = 0, height = 0;  ///< pixels; within its picture
};

/// "X,Y,WIDTH,HEIGHT".
std::string in_words(const CropBox& box);

/// Cut down to what lies within the picture; none where nothing does.
std::optional<CropBox> within(const CropBox& box, Resolution size);

/// The places where pictures differ most from the truth. Sums the errors, each pixel's cut at a quarter of
/// white so that a few wrong pixels do not win.
class ErrorTally {
  public:
    explicit ErrorTally(const Picture& truth);
    void add(const Picture& picture);  ///< of the truth's size

    /// The square of this side, in steps of a third of it, with the greatest sum; the whole picture where it
    /// is smaller.
    CropBox worst(int side) const;

  private:
    const Picture& truth_;
    Plane<float> sum_;
};

/// The box as sRGB, each pixel a square of factor x factor.
Plane<Rgb8> crop(const Picture& picture, const CropBox& box, int factor);

/// The error of its worst channel in the box, from 1/1024 and less (dark) to 1 (light), by its logarithm.
Plane<Rgb8> error_crop(const Picture& picture, const Picture& truth, const CropBox& box, int factor);

}  // namespace zproof
