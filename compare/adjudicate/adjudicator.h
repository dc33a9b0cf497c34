/// The second tier: decides answers by the admissible set, in the surroundings that the scene gives them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "compare/admissible/admissibility.h"
#include "scenes/scene.h"

namespace zproof {

/// An answer to be decided: a triangle of the scene, or none, at a pixel.
struct PixelQuery {
    const ViewBounds* bounds = nullptr;  ///< the renderer's
    PrimitiveId answer = PrimitiveId::none;
    int x = 0, y = 0;
};

/// What became of a query.
struct Adjudicated {
    Decision decision;
    /// Of an answer that is admissible by its place (Admissibility::visible); see admissible/displacement.h.
    std::optional<double> displacement_over_eps;
};

/// Changes what stands around an answer before it is decided: another rule of drawing than the declared one.
using RuleOverride = std::function<void(Neighbourhood& around, PrimitiveId answer)>;

/// What is asked beside admissibility.
enum class Asked {
    admissibility,
    displacement,  ///< Adjudicated::displacement_over_eps as well
};

/// Decides all queries, in their order; on all threads. It takes a pass over the scene whatever their number: put many
/// into one call.
std::vector<Adjudicated> adjudicate(const Scene& scene, const View& view, std::span<const PixelQuery> queries,
                                    Asked asked, const RuleOverride& override = nullptr);

}  // namespace zproof
