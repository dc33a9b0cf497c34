/// The renderer with its rules laid open, for the tests. The public entry is render() of rasterizer.h.
#pragma once

#include <cstdint>
#include <utility>

#include "frame/frame.h"
#include "frame/picture.h"
#include "math/processor.h"
#include "rasterizer/draw_list.h"
#include "rasterizer/front_to_back.h"
#include "rasterizer/kernel.h"
#include "rasterizer/rules.h"
#include "rasterizer/tile_bins.h"
#include "rasterizer/view_setup.h"
#include "scenes/light.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// What a frame was made of. Whole numbers, the same for any number of threads.
struct Work {
    std::uint64_t vertices = 0;  ///< transformed
    BinTally bins;
    std::uint64_t entries = 0;           ///< in tiles: a triangle counts in each tile that it may reach
    std::uint64_t chunks_culled = 0;     ///< left out by their boxes
    std::uint64_t pixels = 0, seen = 0;  ///< of the image; that show a triangle
    Tally tally;
};

/// A picture shaded fragment by fragment while it is drawn.
struct ShadedFrame {
    Picture picture;
    std::uint64_t shaded = 0;  ///< fragments that were shaded
};

/// Vertices, then triangles into tiles, then tiles, each in parallel. Tiles share no pixel and draw as if in
/// scene order, so the bits depend on scene, view and rules alone. What it allocates it keeps for the next
/// frame.
class Pipeline {
  public:
    explicit Pipeline(const Rules& rules, const Kernel& kernel = widest_of(kernels),
                      const Optimizations& optimizations = {})
        : rules_(rules), kernel_(kernel), optimizations_(optimizations), projected_(kernel), bins_(kernel) {}

    /// Valid until the next call. `chunks` are chunks_of(scene): needed where need_chunks() says so, else
    /// unread.
    const Frame& render(const Scene& scene, const View& view, const std::vector<Chunk>& chunks = {});
    /// The frame of the last render(), to be kept; the next one begins a new one.
    Frame take_frame() { return std::exchange(frame_, Frame{}); }

    Plane<std::uint32_t> count_fragments(const Scene& scene, const View& view);

    /// What render() does, counted.
    Work count_work(const Scene& scene, const View& view, const std::vector<Chunk>& chunks = {});

    /// The colours of shade() of shading.h, made while drawing. Hierarchical z is not used before the test,
    /// where every fragment is to be shaded.
    ShadedFrame render_shaded(const Scene& scene, const View& view, const Light& light, ShadingTime time,
                              const std::vector<Chunk>& chunks = {});

  private:
    template <class Visit>
    void for_each_tile(const Visit& visit) const;
    ViewSetup prepare(const Scene& scene, const View& view, const std::vector<Chunk>& chunks);
    bool put_in_order(const ViewSetup& setup);
    TileEntries entries_in(std::size_t tile, bool front_to_back);

    Rules rules_;
    Kernel kernel_;
    Optimizations optimizations_;
    DrawList list_;  ///< of the last prepare(), where the optimizations need chunks
    ProjectedVertices projected_;
    TileBins bins_;
    FrontToBack front_to_back_;
    Frame frame_;
};

/// Renders by the given rules.
Frame render_by(const Rules& rules, const Scene& scene, const View& view,
                const Kernel& kernel = widest_of(kernels));

/// How many fragments each pixel gets before any depth test, by the set-up, bins and scan of render_by(). On
/// a closed front, one layer of a manifold, it is one at every pixel that the front covers.
Plane<std::uint32_t> count_fragments(const Rules& rules, const Scene& scene, const View& view);

}  // namespace zproof::rasterizer
