/// The magnitudes that are judged: within them every product of a ray caster in float32 is finite, and what
/// underflows is less than what it rounds. docs/scenes.md derives each limit.
#pragma once

#include <string>

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// The largest of vertices and eyes, and of all that a parallel projection gives in scene units.
inline constexpr double largest_judged_coordinate = 1e11;

/// What lies outside of the ranges, with its value, the range and the remedy; empty where nothing does.
std::string outside_judged_ranges(const Scene& scene);
std::string outside_judged_ranges(const View& view);

/// Throws SceneError with that text.
void require_judged(const Scene& scene);
void require_judged(const View& view);

}  // namespace zproof
