/// What is asked of the second tier, and what it says.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "compare/admissible/admissibility.h"

namespace zproof {

/// An answer to be decided: a triangle of the scene, or none, at a pixel.
struct PixelQuery {
    const ViewBounds* bounds = nullptr;  ///< the renderer's
    PrimitiveId answer = PrimitiveId::none;
    int x = 0, y = 0;
    AskedReason reason = AskedReason::the_first;
    double depth = std::numeric_limits<double>::quiet_NaN();  ///< that is shown with it, if any is
};

/// What became of a query.
struct QueryResult {
    Decision decision;
    /// The displacement of an answer that is admissible by its place (Admissibility::visible); see
    /// admissible/displacement.h.
    std::optional<double> displacement_over_eps = std::nullopt;
    /// Beyond that, what covers the pixel for certain hides the query's depth.
    double farthest_depth = unlimited;
};

/// Changes what stands around an answer before it is decided: another rule of drawing than the declared one.
using RuleOverride = std::function<void(Neighbourhood& around, PrimitiveId answer)>;

/// What is asked beside admissibility.
enum class QueryDetail {
    admissibility,
    displacement,  ///< Adjudicated::displacement_over_eps as well
};

}  // namespace zproof
