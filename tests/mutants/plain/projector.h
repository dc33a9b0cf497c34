/// From world space to clip space, and on to the picture.
#pragma once

#include "tests/mutants/plain/depth_code.h"

namespace plain {

template <class Real>
struct ClipVertex {
    Real x, y, z, w;
    Real depth;  ///< camera depth; w is 1 in parallel views
};

/// One matrix, each entry rounded once, applied to a corner less the eye.
template <class Real>
class Projector {
  public:
    Projector(const Camera& camera, DepthBuffer buffer)
        : is_parallel_(camera.projection == Projection::parallel) {
        const Window& window = camera.window;
        const double across = window.right - window.left, up = window.top - window.bottom;
        const double middle_x = (window.right + window.left) / 2, middle_y = (window.top + window.bottom) / 2;
        const double step_x = is_parallel_ ? camera.shear_x : middle_x;
        const double step_y = is_parallel_ ? camera.shear_y : middle_y;
        const ZMapping z = z_mapping(camera, buffer);
        x_ = rounded<Real>((2 / across) * (camera.right + step_x * camera.back));
        y_ = rounded<Real>((2 / up) * (camera.up + step_y * camera.back));
        z_ = rounded<Real>(-z.factor * camera.back);
        depth_ = rounded<Real>(-1.0 * camera.back);
        x_offset_ = is_parallel_ ? Real(-2 * middle_x / across) : 0;
        y_offset_ = is_parallel_ ? Real(-2 * middle_y / up) : 0;
        z_offset_ = Real(z.offset);
        eye_ = rounded<Real>(camera.eye);
    }

    ClipVertex<Real> operator()(const Vec3<float>& position) const {
        const Vec3<Real> p = rounded<Real>(position) - eye_;
        const Real depth = dot(depth_, p);
        return {.x = dot(x_, p) + x_offset_,
                .y = dot(y_, p) + y_offset_,
                .z = dot(z_, p) + z_offset_,
                .w = is_parallel_ ? Real(1) : depth,
                .depth = depth};
    }

  private:
    bool is_parallel_;
    Vec3<Real> x_, y_, z_, depth_, eye_;
    Real x_offset_, y_offset_, z_offset_;
};

/// A corner in pixels, y down, and its z.
template <class Real>
struct RasterVertex {
    Real x, y, z;
};

template <class Real>
RasterVertex<Real> raster_vertex(const ClipVertex<Real>& v, const Camera& camera) {
    return {.x = (v.x / v.w + 1) * (Real(camera.width) / 2),
            .y = (1 - v.y / v.w) * (Real(camera.height) / 2),
            .z = v.z / v.w};
}

}  // namespace plain
