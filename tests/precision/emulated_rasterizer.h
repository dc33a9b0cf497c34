/// A z-buffer rasterizer that computes what a declaration says and nothing better. The judge must find no
/// defect in it, and must find some when another declaration is made for it.
#pragma once

#include "frame/frame.h"
#include "frame/precision.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof {

/// Exact edge functions need corners on a grid of at most 8 bits. A homogeneous rasterizer is emulated with
/// DepthBuffer::camera_depth and barycentrics.
Frame emulate(const RasterPrecision& precision, const Scene& scene, const View& view);

}  // namespace zproof
