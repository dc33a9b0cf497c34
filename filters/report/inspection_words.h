/// An inspection of a pixel as text.
#pragma once

#include <string>

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

}  // namespace zproof
