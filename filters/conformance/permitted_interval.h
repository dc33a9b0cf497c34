/// What a picture might have shown: pixel by pixel the colours that its filter reference permits, as float32.
#pragma once

#include "filters/conformance/conformance.h"

namespace zproof {

/// The least and the greatest float32 of each channel of the permitted range that is nearest to the picture's
/// colour. A pixel conforms where it lies between them in every channel. A channel whose least is above its
/// greatest permits no float32; infinite ends permit anything.
struct PermittedInterval {
    Picture least, greatest;
};

/// The interval of one pixel.
struct PermittedFloats {
    LinearRgb least, greatest;
};

PermittedFloats permitted_floats(const LinearRgb& colour, const PermittedColours& permitted);

/// Runs on the threads of the surrounding tbb::task_arena; all of them ask the filter reference.
PermittedInterval permitted_interval(const Picture& picture, const PixelReference& reference,
                                     const FilterPrecision& precision);

/// How far a channel lies outside, in linear light: 0 inside, infinite where it is not finite or no float32
/// is permitted.
double distance_outside(float value, float least, float greatest);

/// That of the colour's worst channel.
double distance_outside(const LinearRgb& colour, const LinearRgb& least, const LinearRgb& greatest);

/// Pixels of the picture that are outside.
std::uint64_t pixels_outside(const Picture& picture, const PermittedInterval& permitted);

}  // namespace zproof
