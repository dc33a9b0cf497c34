/// The colour of one pixel whose triangle is known.
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

    /// The colour that shade() of shading.h gives. The primitive must be a triangle of the scene.
    LinearRgb colour_at(int x, int y, PrimitiveId primitive) const;

  private:
    const Scene& scene_;
    const View& view_;
    const Light& light_;
    glm::dvec3 toward_light_world_;
};

}  // namespace zproof::rasterizer
