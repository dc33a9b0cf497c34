/// Some of an image's pixels, evenly spread: a sample of a view.
#pragma once

#include "frame/frame.h"
#include "scenes/view.h"

namespace zproof {

/// Every stride-th pixel of every stride-th row.
struct PixelLattice {
    int stride = 1;                ///< from 1
    int first_x = 0, first_y = 0;  ///< its upper left pixel: in the image, and below stride
};

/// Its columns and rows in an image.
Resolution size_of(const PixelLattice& lattice, const Resolution& image);

/// A view whose pixel centres are those of the lattice, to the rounding of its window to double. It has the
/// camera, the name and the sample of the other.
View view_of(const PixelLattice& lattice, const View& view);

/// Triangle ids and depths at the lattice; no attributes.
Frame frame_at(const PixelLattice& lattice, const Frame& frame);

}  // namespace zproof
