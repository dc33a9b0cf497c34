/// What an answer earned before the judge.
#pragma once

#include <optional>

#include "compare/truth/standing.h"

namespace zproof {

struct Ruled {
    Decision decision;
    double eps_px = 0;  ///< half-side of the square that it was judged in; NaN where nobody asked for it
    /// Of an answer that is lawful by its place (Standing::visible), where it was asked for.
    std::optional<double> displacement_over_eps;
};

enum class Asked {
    standing,
    standing_and_displacement,  ///< Ruled::displacement_over_eps as well
    without_square,             ///< both, but Ruled::eps_px only where it costs nothing more
};

}  // namespace zproof
