/// May a renderer show this triangle, or background, at this pixel? The one place that says so
/// (docs/truth.md).
#pragma once

#include "compare/admissible/coplanar.h"
#include "compare/admissible/neighbourhood.h"
#include "compare/pixel_class.h"

namespace zproof {

/// Why an answer is admissible, or how it is wrong. Admissible ones first.
enum class Admissibility : std::uint8_t {
    visible,          ///< truly visible (or background truly bare) within eps
    clipped,          ///< the same, and the near or far plane cuts a triangle within eps
    tied,             ///< visible only thanks to the depth bounds
    through_a_crack,  ///< visible only where occluders abut without sharing an edge
    undecidable,      ///< it would take more work than a pixel or its view is given
    hole,             ///< background, but covered for certain
    outside,          ///< the triangle does not reach the square
    hidden,           ///< occluded for certain
};

constexpr bool is_admissible(Admissibility s) { return s < Admissibility::undecidable; }
constexpr bool is_inadmissible(Admissibility s) { return s > Admissibility::undecidable; }

/// Among more triangles than these nothing is decided about a pixel. It bounds time and memory, and no
/// verdict passes by it.
inline constexpr std::size_t most_neighbours = 65'536;

struct Decision {
    Admissibility admissibility = Admissibility::visible;
    bool exact = false;    ///< did double precision leave it to exact rationals?
    double eps_px = 0;     ///< half-side of the square that it was decided in
    std::size_t work = 0;  ///< that it took; see AdmissibleSet::work()
};

/// Which of the reasons for which an answer is admissible is to be told.
enum class AskedReason {
    the_first,  ///< as Admissibility lists them
    any,        ///< `visible` also stands for `clipped`
};

/// Decides one answer: a triangle's id, which must be among the neighbours if it is to be admissible, or
/// none. In double, then by intervals, then by rationals.
Decision decide(const Neighbourhood& around, PrimitiveId answer, AskedReason reason = AskedReason::the_first);

/// What may_lie_at() found.
struct DepthDecision {
    bool may_lie_there = true;
    std::size_t work = 0;  ///< that it took
};

/// May an admissible answer lie there, or does what covers the pixel for certain lie in front of that inverse
/// depth? An image so thin that nothing bounds its depth may turn over: a neighbour that has an edge of it
/// comes to lie beside it then, and hides none of it. Yes where it would take too much work.
DepthDecision may_lie_at(double inverse_depth, const Neighbourhood& around, PrimitiveId answer);

/// The class of a pixel at which the two renderers gave different, each by itself judged, answers.
PixelClass class_of(Admissibility candidate, Admissibility reference);

}  // namespace zproof
