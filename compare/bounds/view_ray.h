/// The view rays around one pixel, exact: what scenes/camera.h says, in the number type asked for.
///
/// Offsets (x, y) are in pixels from the place where the pixel is sampled, y down: its centre, but for
/// samples (sampled_at()). A point at camera depth t on the ray is
///     p_world = origin(x, y) + t direction(x, y).
/// Perspective: origin is the eye, direction is affine in (x, y). Parallel: origin is affine, direction
/// constant.
#pragma once

#include "math/vector3.h"
#include "scenes/view.h"

namespace zproof {

template <class Number>
struct ViewRay {
    Projection projection;
    Vector3<Number> origin, direction;  ///< at the pixel's centre
    Vector3<Number> step_x, step_y;     ///< change of direction (perspective) or origin (parallel) per pixel

    ViewRay() = default;
    ViewRay(const View& view, int pixel_x, int pixel_y);
};

/// The camera depth of a point that lies so far from the ray's origin.
template <class Number>
Number camera_depth(const ViewRay<Number>& ray, const Vector3<Number>& from_origin) {
    const Vector3<Number> along = cross(ray.step_x, ray.step_y);
    return dot(along, from_origin) / dot(along, ray.direction);
}

/// The view rays of one view: what they have in common is worked out once.
template <class Number>
class ViewRays {
  public:
    explicit ViewRays(const View& view)
        : first_(sampled_at(view, 0, 0)),
          left_(view.camera.window.left),
          top_(view.camera.window.top),
          u_per_px_((Number(view.camera.window.right) - left_) / Number(view.width)),
          v_per_px_((Number(view.camera.window.bottom) - top_) / Number(view.height)),
          right_(exactly<Number>(view.camera.right)),
          up_(exactly<Number>(view.camera.up)),
          back_(exactly<Number>(view.camera.back)) {
        const Camera& camera = view.camera;
        common_.projection = camera.projection;
        common_.step_x = u_per_px_ * right_;
        common_.step_y = v_per_px_ * up_;
        common_.origin = exactly<Number>(glm::dvec3(camera.eye_world));
        if (camera.projection == Projection::parallel)
            common_.direction = Number(camera.shear.x) * right_ + Number(camera.shear.y) * up_ - back_;
    }

    ViewRay<Number> at(int pixel_x, int pixel_y) const {
        ViewRay<Number> ray = common_;
        if (ray.projection == Projection::perspective)
            ray.direction = on_plane(pixel_x, pixel_y) - back_;
        else
            ray.origin = ray.origin + on_plane(pixel_x, pixel_y);
        return ray;
    }

  private:
    Vector3<Number> on_plane(int pixel_x, int pixel_y) const {
        const Number u = left_ + u_per_px_ * Number(pixel_x + first_.x);
        const Number v = top_ + v_per_px_ * Number(pixel_y + first_.y);
        return u * right_ + v * up_;
    }

    glm::dvec2 first_;  ///< raster position at which pixel (0, 0) is sampled
    Number left_, top_, u_per_px_, v_per_px_;
    Vector3<Number> right_, up_, back_;
    ViewRay<Number> common_{};
};

template <class Number>
ViewRay<Number>::ViewRay(const View& view, int pixel_x, int pixel_y)
    : ViewRay(ViewRays<Number>(view).at(pixel_x, pixel_y)) {}

}  // namespace zproof
