#include "study/projection/lens.h"

#include <cmath>

namespace zproof::study::projection {

namespace {

template <class Number>
Vector3<Number> rounded(const glm::dvec3& v) {
    return {Number(v.x), Number(v.y), Number(v.z)};
}

/// All but the rows of to_camera.
template <class Number>
Lens<Number> begun(const View& view) {
    const Camera& c = view.camera;
    Lens<Number> lens;
    lens.projection = c.projection;
    lens.eye = rounded<Number>(glm::dvec3(c.eye_world));
    lens.canvas = {Number(c.window.left), Number(c.window.right), Number(c.window.bottom),
                   Number(c.window.top)};
    lens.shear = {Number(c.shear.x), Number(c.shear.y)};
    lens.near = Number(c.near_depth);
    lens.has_far = std::isfinite(c.far_depth);
    lens.far = lens.has_far ? Number(c.far_depth) : Number(0);
    lens.width = Number(view.width), lens.height = Number(view.height);
    const Number at = c.projection == Projection::perspective ? lens.near : Number(1);
    lens.on_near = {at * lens.canvas.left, at * lens.canvas.right, at * lens.canvas.bottom,
                    at * lens.canvas.top};
    return lens;
}

}  // namespace

template <class Number>
Lens<Number> lens_of(const View& view) {
    Lens<Number> lens = begun<Number>(view);
    const Camera& c = view.camera;
    lens.to_camera = {rounded<Number>(c.right), rounded<Number>(c.up), rounded<Number>(c.back)};
    return lens;
}

template <>
Lens<Rational> lens_of<Rational>(const View& view) {
    Lens<Rational> lens = begun<Rational>(view);
    const Camera& c = view.camera;
    const Matrix4<Rational> world_from_camera = coordinate_system<Rational>(
        {exactly<Rational>(c.right), exactly<Rational>(c.up), exactly<Rational>(c.back)},
        {Rational(0), Rational(0), Rational(0)});
    const Matrix4<Rational> inverse = inverse_of(world_from_camera);
    for (std::size_t i = 0; i < 3; ++i) lens.to_camera[i] = {inverse[i][0], inverse[i][1], inverse[i][2]};
    return lens;
}

template Lens<float> lens_of<float>(const View& view);
template Lens<double> lens_of<double>(const View& view);

}  // namespace zproof::study::projection
