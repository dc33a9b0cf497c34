/// Does a filtered picture keep to its promise as a whole? An error that hides within the range of every
/// single pixel is seen where it is the same everywhere (docs/joint-conformance.md).
///
/// Estimated are offsets that a renderer may have everywhere alike, jointly by weighted least squares over
/// all pixels that are told apart; a verdict is given by a test of signs over rows and over columns
/// (sign_test.h).
#pragma once

#include <string>
#include <vector>

#include "compare/conformance.h"

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

/// The false-alarm rate of a picture that keeps its promise, all tests together: 2^-40.
constexpr double log2_false_alarm = -40;

struct JointConformance {
    std::vector<OffsetEstimate> offsets;  ///< in the order of the references
    std::uint64_t pixels = 0;             ///< that were told apart, of those asked about

    bool leaves_promise() const;
};

/// Asks about at most 16384 pixels, evenly taken, on the threads of the surrounding tbb::task_arena.
JointConformance joint_conformance(const Picture& picture, const PixelReference& definition,
                                   const std::vector<OffsetReference>& offsets,
                                   const FilterPrecision& promise);

}  // namespace zproof
