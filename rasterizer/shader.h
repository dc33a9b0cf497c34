/// The colours of pixels whose triangles are known.
#pragma once

#include "frame/frame.h"
#include "frame/picture.h"
#include "scenes/light.h"
#include "scenes/scene.h"
#include "scenes/view.h"

namespace zproof::rasterizer {

/// Scene, view and light must outlive it.
class Shader {
  public:
    Shader(const Scene& scene, const View& view, const Light& light);

    /// The colour that shade() gives. The primitive must be a triangle of the scene.
    LinearRgb colour_at(int x, int y, PrimitiveId primitive) const;

  private:
    const Scene& scene_;
    const View& view_;
    const Light& light_;
    glm::dvec3 toward_light_world_;
};

/// Shades every pixel whose triangle the frame names; background is black. Attributes are interpolated
/// perspective-correctly at the pixel's centre; base colour = factor x texture x vertex colour, the texture
/// read at level 0 by its magnification filter; normals are the vertices' where all three have one, else the
/// triangle's. Alpha is ignored. On the threads of the surrounding tbb::task_arena; ids must be triangles of
/// the scene, or none.
Picture shade(const Scene& scene, const View& view, const Frame& frame, const Light& light);

}  // namespace zproof::rasterizer
