/// The z-buffer renderer under test: world -> camera -> clip -> raster, near clip, guard band, 24.8 fixed
/// point, top-left rule, perspective-correct depth, tiles on all threads. The same bits for any number of
/// threads.
#pragma once

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// What this rasterizer promises (docs/bounds.md): float64 transform, 8 sub-pixel bits, round to nearest.
Precision precision();

/// Renders primary visibility on the threads of the surrounding tbb::task_arena. Both windings are drawn. Of
/// equal stored depths the earlier triangle is seen. A triangle with a vertex that is not finite is left out.
/// The view must be 1 to 32768 px a side; for perspective, depths of 2^-126 to 2^126 scene units keep
/// float32's relative precision, because the z-buffer holds 1 / depth.
Frame render(const Scene& scene, const View& view);

}  // namespace zproof::rasterizer
