/// The renderer with its rules laid open, for the tests. The public entry is render() of rasterizer.h.
#pragma once

#include <cstdint>
#include <utility>

#include "frame/frame.h"
#include "rasterizer/dispatch.h"
#include "rasterizer/rules.h"
#include "rasterizer/tile_bins.h"
#include "rasterizer/view_setup.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// Vertices, then triangles into tiles, then tiles, each in parallel. Tiles share no pixel and draw in scene
/// order, so the bits depend on scene, view and rules alone. What it allocates it keeps for the next frame.
class Pipeline {
  public:
    explicit Pipeline(const Rules& rules, const Kernel& kernel = widest_kernel())
        : rules_(rules), kernel_(kernel) {}

    /// Valid until the next call.
    const Frame& render(const Scene& scene, const View& view);
    /// The frame of the last render(), to be kept; the next one begins a new one.
    Frame take_frame() { return std::exchange(frame_, Frame{}); }

    Plane<std::uint32_t> count_fragments(const Scene& scene, const View& view);

  private:
    Rules rules_;
    Kernel kernel_;
    ProjectedVertices projected_;
    TileBins bins_;
    Frame frame_;
};

/// Renders by the given rules.
Frame render_by(const Rules& rules, const Scene& scene, const View& view,
                const Kernel& kernel = widest_kernel());

/// How many fragments each pixel gets before any depth test, by the set-up, bins and scan of render_by(). On
/// a closed front, one layer of a manifold, it is one at every pixel that the front covers.
Plane<std::uint32_t> count_fragments(const Rules& rules, const Scene& scene, const View& view);

}  // namespace zproof::rasterizer
