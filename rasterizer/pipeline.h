/// The renderer with its rules laid open, for the tests. The public entry is render() of rasterizer.h.
#pragma once

#include "frame/frame.h"
#include "rasterizer/rules.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// Renders by the given rules: vertices, then triangles into tiles, then tiles, each in parallel. Tiles share
/// no pixel and draw in scene order, so the bits depend on scene, view and rules alone.
Frame render_by(const Rules& rules, const Scene& scene, const View& view);

}  // namespace zproof::rasterizer
