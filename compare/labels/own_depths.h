/// Frames of ids alone: each pixel gets the depth of the triangle that it names (docs/labels.md).
#pragma once

#include "compare/rendered_frame.h"

namespace zproof {

/// The frame of these ids with depths that no bound speaks against, as far as there are any: the depth of the
/// named triangle's plane at the pixel's centre, rounded to float32, or the reference's. Background has
/// +infinity; an id that no triangle has, 0. Runs on the threads of the surrounding tbb::task_arena; the
/// result does not depend on their number. Planes have the view's size.
Frame with_own_depths(const Scene& scene, const View& view, const Plane<PrimitiveId>& ids,
                      const Precision& precision, const Frame& reference);

}  // namespace zproof
