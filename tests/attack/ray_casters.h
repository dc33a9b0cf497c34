/// Honest ray casters, written from docs/renderer-contract.md alone. They compute in the arithmetic that they
/// declare, and take each choice that the declaration leaves at its limit.
#pragma once

#include <cstdint>

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::attack {

/// Has a triangle what lies on its edges, and what its tolerance permits?
enum class Inside { open, closed };

struct RayChoices {
    Inside inside = Inside::closed;
    std::uint64_t seed = 0;  ///< of the corner to which each ray's aim, direction, corners and depth err
};

Frame cast(const RayPrecision& precision, const Scene& scene, const View& view, const RayChoices& choices);
Frame cast(const PlaneRayPrecision& precision, const Scene& scene, const View& view,
           const RayChoices& choices);

}  // namespace zproof::attack
