/// How much of its bound an admissible answer needs: the tightness of eps, seen where edges decide.
#pragma once

#include <optional>

#include "compare/admissible/neighbourhood.h"

namespace zproof {

struct LeastDisplacement {
    /// The least half-side of a square around the centre in which the answer is seen, over eps_px of the
    /// neighbourhood; multiples of 1/1024, rounded down, so never 1 for an answer that is admissible by its
    /// place. Nothing where not even 1/1024 is needed: the answer is right at the centre, or it would take
    /// too much work.
    std::optional<double> over_eps;
    std::size_t work = 0;  ///< that it took; see AdmissibleSet::work()
};

/// An estimate in double, for statistics; it decides nothing (docs/bounds.md, "Is the bound tight?").
///
/// For a triangle that misses the centre this is how far its corners must have moved; for one that others
/// hide there, or for background, how far those others must have moved aside.
LeastDisplacement displacement_of(const Neighbourhood& around, PrimitiveId answer);

}  // namespace zproof
