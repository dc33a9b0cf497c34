/// What the filter reference says of some of a picture's pixels, for the joint check: asked once, for any
/// number of pictures.
#pragma once

#include <span>

#include "filters/conformance/joint_conformance.h"

namespace zproof {

/// One value per channel of every pixel told apart.
using Values = std::vector<double>;

/// How a picture answers to one offset.
struct Response {
    Values change;            ///< of the value per unit of the offset
    Values admitted;          ///< how far the promise of this offset alone moves the value
    Values unique;            ///< the change that no other offset can imitate: orthogonal to theirs
    double unique_share = 0;  ///< of the change's square

    bool is_told() const;
};

struct Samples {
    std::vector<FilterPixel> pixels;
    Values exact;   ///< what the exact definition shows
    Values weight;  ///< 1 / (half-width of what the promise permits)^2
    std::vector<Response> responses;
    std::vector<Values> alternatives;  ///< what each shows less what the definition shows; 0 where undecided
};

/// Of at most 16384 pixels, evenly taken, on the threads of the surrounding tbb::task_arena.
Samples samples_of(const Resolution& size, const JointReferences& references, const FilterPrecision& promise);

/// What the picture shows there; where that is no number, what the definition shows.
Values shown_by(const Picture& picture, const Samples& samples);

/// The only range that is permitted; nothing where several are, or anything is.
std::optional<ColourRange> only_range(const PixelReference& reference, const FilterPixel& p,
                                      const FilterPrecision& precision);

/// What an exact definition shows there; nothing for a pixel's channels where a decision is undecided.
std::vector<std::optional<glm::dvec3>> values_of(const PixelReference& definition,
                                                 std::span<const FilterPixel> pixels);

double weighted_dot(const Values& weight, const Values& a, const Values& b);

/// What is left of values when the changes but one were removed from them (Gram and Schmidt; Frisch, Waugh
/// and Lovell: what it tells of a picture is what the joint fit tells).
Values without(const Values& weight, Values values, std::span<const Values* const> changes);

/// Is so large a share of a square left that rounding did not make it? Then at least half of a double's
/// digits are.
inline bool is_left(double rest, double whole) { return rest > 0x1p-26 * whole; }

}  // namespace zproof
