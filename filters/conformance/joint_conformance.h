/// Does a filtered picture keep to its promise as a whole? An error that hides within the range of every
/// single pixel is seen where it is the same everywhere (docs/joint-conformance.md).
///
/// Estimated are offsets that a renderer may have everywhere alike, jointly by weighted least squares over
/// all pixels that are told apart; a verdict is given by a test of signs over rows and over columns
/// (sign_probability.h).
#pragma once

#include <string>
#include <vector>

#include "filters/conformance/conformance.h"

namespace zproof {

/// A quantity that may be off by the same everywhere.
struct OffsetReference {
    std::string name, unit;
    double step = 0;              ///< by which the quantity is less and more in these two definitions
    PixelReference below, above;  ///< the definition with the quantity changed
    FilterPrecision own;          ///< what is promised of this quantity, and all else exact
};

struct OffsetEstimate {
    std::string name, unit;
    double value = 0, standard_error = 0;
    double promised = 0;     ///< the largest offset that the promise admits, on the pixels' average
    double log2_chance = 0;  ///< of so large an offset where the promise is kept; a bound
    bool is_told = false;    ///< the picture depends on it, and not only as on another one
    bool leaves_promise = false;
};

/// Another arithmetic or another rule, that the promise rules out.
struct AlternativeReference {
    std::string name;  ///< "weights of 6 bits, rounded down"
    PixelReference reference;
};

/// How much of the way from the definition to the alternative the picture lies, offsets aside.
struct AlternativeFit {
    std::string name;
    double share = 0, standard_error = 0;  ///< 0: at the definition; 1: at the alternative
    double log2_chance = 0;  ///< of a picture of the definition being so much nearer to it; a bound
    bool is_told = false;    ///< the two differ, and not only as offsets do
    bool is_nearer = false;  ///< the picture is the alternative's
};

/// What a picture is held against.
struct JointReferences {
    PixelReference definition;
    std::vector<OffsetReference> offsets;
    std::vector<AlternativeReference> alternatives;
};

/// The false-alarm rate of a picture that keeps its promise, all tests together: 2^-40.
constexpr double log2_false_alarm = -40;

struct JointConformance {
    std::vector<OffsetEstimate> offsets;       ///< in the order of the references
    std::vector<AlternativeFit> alternatives;  ///< in the order of the references
    std::uint64_t pixels = 0;                  ///< that were told apart, of those asked about

    bool leaves_promise() const;
};

/// Asks about at most 16384 pixels, evenly taken, on the threads of the surrounding tbb::task_arena.
JointConformance joint_conformance(const Picture& picture, const JointReferences& references,
                                   const FilterPrecision& promise);

}  // namespace zproof
