/// The z-buffer renderer under test: world -> camera -> clip -> raster, near clip, guard band, 24.8 fixed
/// point, top-left rule, perspective-correct depth, tiles on all threads. The same bits for any number of
/// threads.
#pragma once

#include <memory>
#include <string>

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

/// render() for frame after frame: memory is kept, and nothing is allocated once it has seen the like.
class Renderer {
  public:
    Renderer();
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// The frame is valid until the next call.
    const Frame& render(const Scene& scene, const View& view);

  private:
    std::unique_ptr<class Pipeline> pipeline_;
};

}  // namespace zproof::rasterizer
