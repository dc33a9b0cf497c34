/// The z-buffer as the lecture counts it, in stages that can be left out: what separates constants that all
/// multiply the number of vertices.
#pragma once

#include <string>
#include <vector>

#include "frame/frame.h"
#include "rasterizer/tile_bins.h"
#include "rasterizer/view_setup.h"

namespace zproof::study::cost {

/// A set of stages; `raster` needs `transform`.
struct Stages {
    using Set = unsigned;
    static constexpr Set bus = 1;        ///< positions and normals are copied: 24 bytes a vertex
    static constexpr Set transform = 2;  ///< world to snapped raster coordinates
    static constexpr Set shade = 4;      ///< Blinn-Phong at every vertex
    static constexpr Set raster = 8;     ///< triangles set up, binned and scanned; frame cleared and written
    static constexpr Set all = 15;
};

/// "bus + transform".
std::string words_for(Stages::Set stages);

/// Scene and view must outlive it. A plain z-buffer: no hierarchical z, no culling.
class LecturePipeline {
  public:
    LecturePipeline(const Scene& scene, const View& view);

    /// Runs once through the stages. Where `transform` is left out, `raster` must be too.
    void run(Stages::Set stages);

    const Frame& frame() const { return frame_; }  ///< of the last run with `raster`

  private:
    void copy();
    void shade();
    void rasterize();

    const Scene& scene_;
    rasterizer::ViewSetup setup_;
    glm::vec3 eye_world_;
    Bulk<glm::vec3> normals_, bus_positions_, bus_normals_, colours_;
    rasterizer::ProjectedVertices projected_;
    rasterizer::TileBins bins_;
    Frame frame_;
};

}  // namespace zproof::study::cost
