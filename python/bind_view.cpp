#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "python/arrays.h"
#include "python/bindings.h"

namespace zproof::python {
namespace {

using api::Size;
using api::View;
using Point = std::array<double, 3>;

/// Numbers of any kind as doubles, by rows.
template <std::size_t count>
std::array<double, count> numbers(const py::object& object, const Wanted& wanted) {
    const py::module_ numpy = py::module_::import("numpy");
    py::array array;
    try {
        array = numpy.attr("asanyarray")(object);
    } catch (const py::error_already_set& e) {
        if (!e.matches(PyExc_ValueError) && !e.matches(PyExc_TypeError)) throw;
    }
    const bool holds_numbers = std::string("fiu").find(array.dtype().kind()) != std::string::npos;
    if (array.size() == 0 || !holds_numbers || py::hasattr(array, "mask"))
        throw py::value_error(wanted.name + " holds no numbers; expected " + wanted.meaning);
    const auto values = array_from<double>(
        numpy.attr("ascontiguousarray")(numpy.attr("atleast_1d")(array), py::arg("dtype") = "float64"),
        wanted);
    std::array<double, count> taken{};
    std::ranges::copy(values_of(values), taken.begin());
    return taken;
}

Point point(const char* name, const py::object& object) {
    return numbers<3>(object, {name, {3}, "3 numbers, world space"});
}

View::Placed placed(const py::object& eye, const py::object& target, const py::object& up, double near,
                    double far, const py::object& size, const std::string& name) {
    return {.eye = point("eye", eye),
            .target = point("target", target),
            .up = point("up", up),
            .near_depth = near,
            .far_depth = far,
            .size = size_from(size),
            .name = name};
}

py::array_t<double> matrix(std::span<const double> values, py::ssize_t rows) {
    return py::array_t<double>({rows, py::ssize_t(values.size()) / rows}, values.data());
}

py::tuple opencv_of(const View& view) {
    const View::OpenCv camera = view.opencv();
    return py::make_tuple(matrix(camera.K, 3), matrix(camera.R, 3), py::array_t<double>(3, camera.t.data()));
}

View from_opencv(const py::object& K, const py::object& R, const py::object& t, const py::object& size,
                 const std::optional<double>& near, double far, const std::string& name) {
    if (!near)
        throw py::type_error(
            "near is missing; expected the camera depth of the near plane, which K, R and t do not have");
    // t may be a column, as OpenCV gives it
    const py::object flat_t = py::module_::import("numpy").attr("ravel")(t);
    return View::from_opencv({.K = numbers<9>(K, {"K", {3, 3}, "3 x 3 numbers"}),
                              .R = numbers<9>(R, {"R", {3, 3}, "3 x 3 numbers"}),
                              .t = numbers<3>(flat_t, {"t", {3}, "3 numbers"})},
                             size_from(size), *near, far, name);
}

std::string text_of(const View& view) {
    const auto [width, height] = view.size();
    return "<zproof.View '" + view.name() + "', " + std::to_string(width) + " x " + std::to_string(height) +
           (view.is_perspective() ? "" : ", parallel") + ">";
}

}  // namespace

void bind_view(py::module_& module) {
    using py::arg;
    const double infinity = std::numeric_limits<double>::infinity();
    const py::tuple up = py::make_tuple(0, 1, 0);
    py::class_<View>(module, "View", "A camera and a picture's size. size is (width, height) in pixels.")
        .def_static(
            "perspective",
            [](const py::object& eye, const py::object& target, const py::object& up_world, double yfov,
               double near, double far, const py::object& size, const std::string& name) {
                return View::perspective(placed(eye, target, up_world, near, far, size, name), yfov);
            },
            py::kw_only(), arg("eye"), arg("target"), arg("up") = up, arg("yfov"), arg("near"),
            arg("far") = infinity, arg("size"), arg("name") = "view",
            "A symmetric perspective. eye, target, up: 3 numbers, world space; the eye is rounded to "
            "float32.\n"
            "yfov: radians, between 0 and pi. near, far: camera depths, 0 < near < far <= inf.\n"
            "Raises ValueError for numbers out of range.")
        .def_static(
            "orthographic",
            [](const py::object& eye, const py::object& target, const py::object& up_world, double height,
               double near, double far, const py::object& size, const std::string& name) {
                return View::orthographic(placed(eye, target, up_world, near, far, size, name), height);
            },
            py::kw_only(), arg("eye"), arg("target"), arg("up") = up, arg("height"), arg("near"), arg("far"),
            arg("size"), arg("name") = "view",
            "An orthographic view of a window `height` scene units high; far must be finite.\n"
            "Raises ValueError for numbers out of range.")
        .def_static(
            "from_opencv", &from_opencv, arg("K"), arg("R"), arg("t"), arg("size"), arg("near") = py::none(),
            arg("far") = infinity, arg("name") = "view",
            "A camera by OpenCV's conventions: p_camera = R p_world + t, x right, y down, z forward; the\n"
            "centre of the top left pixel is at (0, 0) of the image that K maps to. K: (3, 3) without skew,\n"
            "R: (3, 3), a rotation to within 1e-5, of which the nearest one in double is taken; t: 3 "
            "numbers.\n"
            "near must be named: K, R and t have none. The eye is rounded to float32: give the renderer "
            "what\n"
            ".opencv says. Raises ValueError.")
        .def_property_readonly("name", &View::name)
        .def_property_readonly(
            "size", [](const View& view) { return py::make_tuple(view.size().width, view.size().height); },
            "(width, height), pixels")
        .def_property_readonly(
            "shape", [](const View& view) { return py::make_tuple(view.size().height, view.size().width); },
            "(height, width), of arrays")
        .def_property_readonly("near", &View::near_depth)
        .def_property_readonly("far", &View::far_depth)
        .def_property_readonly("is_perspective", &View::is_perspective)
        .def_property_readonly(
            "opencv", &opencv_of,
            "(K, R, t) as float64, of the camera that is judged. Raises ValueError for a parallel "
            "projection.")
        .def_property_readonly(
            "camera_from_world",
            [](const View& view) { return matrix(view.matrices().camera_from_world, 4); },
            "float64 (4, 4), for column vectors; the camera looks down -z, y up")
        .def_property_readonly(
            "clip_from_camera", [](const View& view) { return matrix(view.matrices().clip_from_camera, 4); },
            "float64 (4, 4), OpenGL's clip space: z in [-w, w]")
        .def("__repr__", &text_of);
}

}  // namespace zproof::python
