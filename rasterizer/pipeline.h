/// The renderer with its rules laid open, for the tests. The public entry is render() of rasterizer.h.
#pragma once

#include <cstdint>

#include "frame/frame.h"
#include "rasterizer/rules.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// Renders by the given rules: vertices, then triangles into tiles, then tiles, each in parallel. Tiles share
/// no pixel and draw in scene order, so the bits depend on scene, view and rules alone.
Frame render_by(const Rules& rules, const Scene& scene, const View& view);

/// How many fragments each pixel gets before any depth test, by the set-up, bins and scan of render_by(). On
/// a closed front, one layer of a manifold, it is one at every pixel that the front covers.
Plane<std::uint32_t> count_fragments(const Rules& rules, const Scene& scene, const View& view);

}  // namespace zproof::rasterizer
