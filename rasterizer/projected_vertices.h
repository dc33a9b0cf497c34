/// The first stage: a scene's vertices on the sub-pixel grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/bulk.h"
#include "math/processor.h"
#include "rasterizer/draw_list.h"
#include "rasterizer/kernel.h"
#include "rasterizer/view_setup.h"
#include "scenes/scene.h"

namespace zproof::rasterizer {

/// The vertices of a scene as one view sees them.
class ProjectedVertices {
  public:
    explicit ProjectedVertices(const Kernel& kernel = widest_of(kernels)) : kernel_(kernel) {}

    /// Transforms every vertex once, on the threads of the surrounding tbb::task_arena. Memory is kept from
    /// the time before.
    void fill(const Vertices& vertices, const ViewSetup& setup);

    /// Projects only some vertices; what is known of the others means nothing.
    void fill(const Vertices& vertices, const ViewSetup& setup, std::span<const IndexRange> ranges);

    /// Meaningful where the outcode has no needs_clip and no not_finite bit.
    const Bulk<SnappedVertex>& snapped() const { return snapped_; }
    const Bulk<std::uint8_t>& outcode() const { return outcode_; }

  private:
    Kernel kernel_;
    Bulk<SnappedVertex> snapped_;
    Bulk<std::uint8_t> outcode_;
};

}  // namespace zproof::rasterizer
