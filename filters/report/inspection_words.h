/// An inspection of a pixel as text.
#pragma once

#include <string>

#include "filters/conformance/permitted_interval.h"
#include "filters/study/inspection.h"

namespace zproof {

/// So many taps are listed one by one.
inline constexpr std::size_t most_listed_taps = 64;

/// Why the method is off there, told by the numbers of the inspection alone: "reads level 3.2 for a minor
/// axis of 2.1 texels: blur along the minor axis (its weights spread over 2.31 texels, the pixel's over
/// 0.9)".
std::string why(const study::PixelInspection& inspection);

/// "pixel 9,99, ewa-true: ..." with why(); one line.
std::string in_a_line(const study::PixelInspection& inspection);

/// All of it: footprint, levels, weights, taps and result, a fact a line.
std::string in_words(const study::PixelInspection& inspection);

/// What a picture has at a pixel, beside what the method permits there that it claims to be of.
struct ClaimedPixel {
    std::string method, promise;  ///< as typed; promise empty: that of zproof's own filters
    LinearRgb value;
    PermittedFloats permitted;
};

bool is_outside(const ClaimedPixel& claimed);

/// "the picture is within what trilinear-gl permits, promising gpu"
std::string in_a_line(const ClaimedPixel& claimed);

/// The same, and value and permitted interval of each channel, a line each. Nine digits tell a float32.
std::string in_words(const ClaimedPixel& claimed);

}  // namespace zproof
