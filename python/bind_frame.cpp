#include "python/arrays.h"
#include "python/bindings.h"

namespace zproof::python {
namespace {

using api::Frame;

std::vector<py::ssize_t> shape_of(const Frame& frame) { return {frame.size().height, frame.size().width}; }

template <Frame (*render)(const api::Scene&, const api::View&)>
Frame frame_by(const py::object& of_scene, const py::object& of_view) {
    const api::Scene& scene = scene_from(of_scene);
    const api::View& view = view_from(of_view, scene);
    const py::gil_scoped_release released;
    return render(scene, view);
}

}  // namespace

void bind_frame(py::module_& module) {
    using py::arg;
    py::class_<Frame>(module, "Frame", "Ids and depths of one view.")
        .def_property_readonly(
            "id",
            [](const py::object& self) {
                const auto& frame = self.cast<const Frame&>();
                return array_of(frame.id(), shape_of(frame), self);
            },
            "uint32 (height, width), read-only; BACKGROUND_ID where nothing is seen")
        .def_property_readonly(
            "depth",
            [](const py::object& self) {
                const auto& frame = self.cast<const Frame&>();
                return array_of(frame.depth(), shape_of(frame), self);
            },
            "float32 (height, width), read-only: along the view axis, scene units; +inf where nothing is "
            "seen");
    module.def(
        "render", &frame_by<api::render>, arg("scene"), arg("view"),
        "The view by zproof's own z-buffer rasterizer. Raises ValueError for a view that is not judged.");
    module.def("trace", &frame_by<api::trace>, arg("scene"), arg("view"),
               "The view by Embree, a ray through each pixel's centre. Raises ValueError as render() does.");
}

}  // namespace zproof::python
