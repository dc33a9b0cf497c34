#include "lessons/projection/camera.h"

#include <cmath>

namespace zproof::study::projection {

namespace {

template <class Number>
Vector3<Number> rounded(const glm::dvec3& v) {
    return {Number(v.x), Number(v.y), Number(v.z)};
}

/// The camera without the rows of to_camera.
template <class Number>
NumericCamera<Number> begun(const View& view) {
    const Camera& c = view.camera;
    NumericCamera<Number> camera;
    camera.projection = c.projection;
    camera.eye = rounded<Number>(glm::dvec3(c.eye_world));
    camera.canvas = {Number(c.window.left), Number(c.window.right), Number(c.window.bottom),
                     Number(c.window.top)};
    camera.shear = {Number(c.shear.x), Number(c.shear.y)};
    camera.near = Number(c.near_depth);
    camera.has_far = std::isfinite(c.far_depth);
    camera.far = camera.has_far ? Number(c.far_depth) : Number(0);
    camera.width = Number(view.width), camera.height = Number(view.height);
    const Number at = c.projection == Projection::perspective ? camera.near : Number(1);
    camera.on_near = {at * camera.canvas.left, at * camera.canvas.right, at * camera.canvas.bottom,
                      at * camera.canvas.top};
    return camera;
}

}  // namespace

template <class Number>
NumericCamera<Number> camera_of(const View& view) {
    NumericCamera<Number> camera = begun<Number>(view);
    const Camera& c = view.camera;
    camera.to_camera = {rounded<Number>(c.right), rounded<Number>(c.up), rounded<Number>(c.back)};
    return camera;
}

template <>
NumericCamera<Rational> camera_of<Rational>(const View& view) {
    NumericCamera<Rational> camera = begun<Rational>(view);
    const Camera& c = view.camera;
    const Matrix4<Rational> world_from_camera = coordinate_system<Rational>(
        {exactly<Rational>(c.right), exactly<Rational>(c.up), exactly<Rational>(c.back)},
        {Rational(0), Rational(0), Rational(0)});
    const Matrix4<Rational> inverse = inverse_of(world_from_camera);
    for (std::size_t i = 0; i < 3; ++i) camera.to_camera[i] = {inverse[i][0], inverse[i][1], inverse[i][2]};
    return camera;
}

template NumericCamera<float> camera_of<float>(const View& view);
template NumericCamera<double> camera_of<double>(const View& view);

}  // namespace zproof::study::projection
