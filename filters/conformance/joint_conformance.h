/// Does a filtered picture keep to its promise as a whole? An error that hides within the range of every
/// single pixel is seen where it is the same everywhere (docs/joint-conformance.md).
///
/// Estimated are offsets that a renderer may have everywhere alike, jointly by weighted least squares over
/// all pixels that are told apart (joint_fit.h); a verdict is given by a test of signs over rows and over
/// columns (sign_probability.h).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "filters/conformance/conformance.h"

namespace zproof {

/// A quantity that may be off by the same everywhere.
struct OffsetReference {
    std::string name, unit;
    FilterPrecision own;  ///< what is promised of this quantity, and all else exact
};

/// Offsets by which a picture's change is found, in their units: small beside a texel and a level, large
/// beside what a reference leaves open (2^-24).
constexpr double joint_step = 0x1p-10;

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
    std::vector<OffsetReference> offsets;
    /// The definition with its quantities so far off, by the order of `offsets`.
    std::function<PixelReference(const std::vector<double>&)> shifted;
    std::vector<AlternativeReference> alternatives;
};

/// The false-alarm rate of a picture that keeps its promise, all tests together: 2^-40.
constexpr double log2_false_alarm = -40;

struct JointConformance {
    std::vector<OffsetEstimate> offsets;       ///< in the order of the references
    std::vector<AlternativeFit> alternatives;  ///< in the order of the references
    std::uint64_t pixels = 0;                  ///< that were told apart, of those asked about
    bool has_converged = false;                ///< the offsets are those with which the definition is nearest
    double explained = 0;          ///< share of those pixels that the definition permits with these offsets
    double log2_least_chance = 0;  ///< an offset or alternative of this chance, or less, is refused

    bool leaves_promise() const;
    /// Do the estimates say how far the quantities are off? Not where offsets alone do not make the picture.
    bool are_offsets_known() const { return has_converged && explained == 1; }
};

struct Samples;

/// The references are asked once, for any number of pictures of one size: about at most 16384 pixels, evenly
/// taken, on the threads of the surrounding tbb::task_arena.
class JointCheck {
  public:
    JointCheck(const Resolution& size, JointReferences references, const FilterPrecision& promise);
    JointConformance judge(const Picture& picture) const;

  private:
    JointReferences references_;
    FilterPrecision promise_;
    std::shared_ptr<const Samples> samples_;
    double log2_least_chance_ = 0;
};

}  // namespace zproof
