/// The lines of sight around one pixel, exact: what scenes/camera.h says, in the number type asked for.
///
/// Offsets (x, y) are in pixels from the pixel's centre, y down. A point at camera depth t on the line of
/// sight is
///     p_world = origin(x, y) + t direction(x, y).
/// Perspective: origin is the eye, direction is affine in (x, y). Parallel: origin is affine, direction
/// constant.
#pragma once

#include "math/vector3.h"
#include "scenes/view.h"

namespace zproof {

template <class Number>
struct Sight {
    Projection projection;
    Vector3<Number> origin, direction;  ///< at the pixel's centre
    Vector3<Number> step_x, step_y;     ///< change of direction (perspective) or origin (parallel) per pixel

    Sight(const View& view, int pixel_x, int pixel_y) : projection(view.camera.projection) {
        const Camera& camera = view.camera;
        const Window& window = camera.window;
        const auto right = exactly<Number>(camera.right), up = exactly<Number>(camera.up);
        const auto back = exactly<Number>(camera.back);
        const Number u_per_px = (Number(window.right) - Number(window.left)) / Number(view.width);
        const Number v_per_px = (Number(window.bottom) - Number(window.top)) / Number(view.height);
        const Number u = Number(window.left) + u_per_px * Number(pixel_x + 0.5);
        const Number v = Number(window.top) + v_per_px * Number(pixel_y + 0.5);
        step_x = u_per_px * right;
        step_y = v_per_px * up;
        origin = exactly<Number>(glm::dvec3(camera.eye_world));
        const auto on_plane = u * right + v * up;
        if (projection == Projection::perspective) {
            direction = on_plane - back;
        } else {
            origin = origin + on_plane;
            direction = Number(camera.shear.x) * right + Number(camera.shear.y) * up - back;
        }
    }
};

}  // namespace zproof
