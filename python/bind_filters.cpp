#include "zproof/filters.h"

#include <pybind11/stl.h>

#include "python/arrays.h"
#include "python/bindings.h"

namespace zproof::python {
namespace {

/// An array that owns the vector.
template <class T>
py::array_t<T> array_taking(std::vector<T>&& values, std::vector<py::ssize_t> shape) {
    auto owned = std::make_unique<std::vector<T>>(std::move(values));
    const std::vector<T>& kept = *owned;
    const py::capsule owner(owned.release(), [](void* p) { delete static_cast<std::vector<T>*>(p); });
    return py::array_t<T>(std::move(shape), kept.data(), owner);
}

py::tuple truth_of(const api::Scene& scene, const api::View& view, const std::string& reconstruction) {
    api::Truth truth;
    {
        const py::gil_scoped_release released;
        truth = api::truth(scene, view, reconstruction);
    }
    const py::ssize_t height = truth.size.height, width = truth.size.width;
    return py::make_tuple(array_taking(std::move(truth.rgb), {height, width, 3}),
                          array_taking(std::move(truth.half_width), {height, width}));
}

void save_picture(const std::string& file, const py::object& picture) {
    const auto array =
        array_from<float>(picture, {"picture", {-1, -1, 3}, "float32 (height, width, 3), linear light"});
    api::save_picture(file, {int(array.shape(1)), int(array.shape(0))}, values_of(array));
}

py::array_t<float> load_picture(const std::string& file) {
    api::LoadedPicture loaded;
    {
        const py::gil_scoped_release released;
        loaded = api::load_picture(file);
    }
    return array_taking(std::move(loaded.rgb), {loaded.size.height, loaded.size.width, 3});
}

/// (factor, [(pixels, coordinates, jacobian, levels)])
py::tuple filter_task(const api::Scene& scene, const api::View& view) {
    api::FilterTask task;
    {
        const py::gil_scoped_release released;
        task = api::filter_task(scene, view);
    }
    py::list textures;
    for (api::TexturedPixels& seen : task.textures) {
        py::list levels;
        for (api::LevelImage& level : seen.levels)
            levels.append(array_taking(std::move(level.rgb), {level.size.height, level.size.width, 3}));
        const auto count = py::ssize_t(seen.pixels.size());
        textures.append(py::make_tuple(array_taking(std::move(seen.pixels), {count}),
                                       array_taking(std::move(seen.coordinates), {count, 2}),
                                       array_taking(std::move(seen.jacobian), {count, 2, 2}), levels));
    }
    return py::make_tuple(array_taking(std::move(task.factor), {task.size.height, task.size.width, 3}),
                          textures);
}

}  // namespace

void bind_filters(py::module_& module) {
    using py::arg;
    module.def("truth", &truth_of, arg("scene"), arg("view"), arg("reconstruction"));
    module.def("save_picture", &save_picture, arg("file"), arg("picture"));
    module.def("filter_task", &filter_task, arg("scene"), arg("view"));
    module.def("load_picture", &load_picture, arg("file"));
    module.def(
        "save_scene",
        [](const api::Scene& scene, const std::vector<api::View>& views, const std::string& folder) {
            const py::gil_scoped_release released;
            api::save(scene, views, folder);
        },
        arg("scene"), arg("views"), arg("folder"));
}

}  // namespace zproof::python
