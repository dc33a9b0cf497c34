/// Frames and verdicts as pictures for people.
#pragma once

#include <algorithm>

#include "compare/pixel_class.h"
#include "frame/frame.h"
#include "frame/picture.h"

namespace zproof {

/// A colour per id, the same in every picture; background is dark.
Plane<Rgb8> picture_of_ids(const Plane<PrimitiveId>& ids);

/// Logarithm of depth over the range of finite positive depths, near bright, far dark blue; background dark;
/// what is no depth (NaN, zero, negative) is magenta.
Plane<Rgb8> picture_of_depths(const Plane<float>& depths);

/// colour_of(class) at every pixel.
Plane<Rgb8> picture_of_classes(const Plane<PixelClass>& classes);

/// Linear light as sRGB; beyond [0, 1] it is cut, what is no number is magenta.
Plane<Rgb8> picture_of_light(const Picture& picture);

/// The greatest difference of the three channels: dark where there is none, then viridis over its square
/// root, so that small ones show; 1 and more is brightest, NaN magenta.
Plane<Rgb8> picture_of_difference(const Picture& a, const Picture& b);

inline constexpr int small_side = 480;  ///< longest side of a small picture, pixels

/// The least whole factor that brings size down to small_side.
int shrink_factor(Resolution size);

/// A size with a pixel for each factor x factor block.
Resolution shrunk(Resolution size, int factor);

/// One pixel out of each factor x factor block: its middle. Colours are never mixed.
template <class T>
Plane<T> thinned(const Plane<T>& values, int factor) {
    const Resolution full = values.size();
    Plane<T> small(shrunk(full, factor));
    for (int y = 0; y < small.size().height; ++y)
        for (int x = 0; x < small.size().width; ++x)
            small.at(x, y) = values.at(std::min(x * factor + factor / 2, full.width - 1),
                                       std::min(y * factor + factor / 2, full.height - 1));
    return small;
}

/// The severest class of each factor x factor block.
Plane<PixelClass> pooled_by_severity(const Plane<PixelClass>& classes, int factor);

/// Every failing pixel grown to 3x3, so that a single one is seen; the severest wins.
Plane<PixelClass> with_dots(const Plane<PixelClass>& classes);

/// Does small_class_map() dot the map of a view of this size?
bool has_dots(Resolution view);

/// The class map for a page: pooled to small_side and, where a page may shrink it further, dotted.
Plane<PixelClass> small_class_map(const Plane<PixelClass>& classes);

}  // namespace zproof
