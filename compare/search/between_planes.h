/// Scenes that neither the near nor the far plane cuts.
#pragma once

#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// Do all vertices lie between the planes and on neither? Then no triangle does what
/// AdmissibleSet::is_clipped asks for. On all threads.
bool lies_between_planes(const Scene& scene, const View& view);

}  // namespace zproof
