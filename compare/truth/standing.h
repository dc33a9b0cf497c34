/// How one renderer's answer at one pixel stands before the scene.
#pragma once

#include "compare/pixel_class.h"
#include "compare/truth/coplanar.h"
#include "compare/truth/neighbourhood.h"

namespace zproof {

/// Why an answer is lawful, or how it is wrong. Lawful ones first.
enum class Standing : std::uint8_t {
    visible,          ///< truly visible (or background truly bare) within eps
    clipped,          ///< the same, and the near or far plane cuts a triangle within eps
    tied,             ///< visible only thanks to the depth bounds
    through_a_crack,  ///< visible only where occluders abut without sharing an edge
    hole,             ///< background, but covered for certain
    outside,          ///< the triangle does not reach the square
    hidden,           ///< occluded for certain
};

constexpr bool is_lawful(Standing s) { return s < Standing::hole; }

struct Decision {
    Standing standing = Standing::visible;
    bool exact = false;  ///< did double precision leave it to exact rationals?
};

/// Decides one answer: a triangle's id, which must be among the neighbours if it is to be lawful, or none.
Decision decide(const Neighbourhood& around, PrimitiveId answer);
/// The same, for many answers among the same triangles.
Decision decide(const Neighbourhood& around, PrimitiveId answer, CoplanarMemory& memory);

/// The class of a pixel at which the two renderers gave different, each by itself judged, answers.
PixelClass class_of(Standing candidate, Standing reference);

}  // namespace zproof
