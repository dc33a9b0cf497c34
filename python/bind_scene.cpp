#include <pybind11/stl.h>

#include "python/arrays.h"
#include "python/bindings.h"

namespace zproof::python {
namespace {

using api::Scene;

/// A length that is too long for a texture becomes one that is refused as well.
int side_of(py::ssize_t length) {
    return int(std::min<py::ssize_t>(length, std::numeric_limits<int>::max()));
}

Scene scene_of(const py::object& positions, const py::object& triangles, const py::object& uv,
               const py::object& texture, const std::string& name) {
    const auto p = array_from<float>(positions, {"positions", {-1, 3}, "float32 (n, 3)"});
    const auto t = array_from<std::uint32_t>(triangles, {"triangles", {-1, 3}, "uint32 (m, 3)"});
    api::Mesh mesh{.positions_world = values_of(p), .triangles = values_of(t), .name = name};
    py::object kept_uv, kept_texels;
    if (!uv.is_none()) {
        const auto array =
            array_from<float>(uv, {"uv", {p.shape(0), 2}, "float32 (n, 2), as many as positions"});
        mesh.uv = values_of(array);
        kept_uv = array;
    }
    if (!texture.is_none()) {
        const auto texels =
            array_from<std::uint8_t>(texture, {"texture", {-1, -1, 4}, "uint8 (height, width, 4), sRGB"});
        if (texels.size() == 0)
            throw py::value_error("texture holds no texel; expected uint8 (height, width, 4)");
        mesh.texels = values_of(texels);
        mesh.texture_size = {side_of(texels.shape(1)), side_of(texels.shape(0))};
        kept_texels = texels;
    }
    const py::gil_scoped_release released;
    return Scene{mesh};
}

std::string text_of(const Scene& scene) {
    return "<zproof.Scene '" + scene.name() + "', " + std::to_string(scene.triangle_count()) + " triangles>";
}

template <class T>
py::array_t<T> threes(std::span<const T> values, const py::object& owner) {
    return array_of<T>(values, {py::ssize_t(values.size()) / 3, 3}, owner);
}

}  // namespace

void bind_scene(py::module_& module) {
    using py::arg;
    py::class_<Scene>(module, "Scene", "Triangles in world space; a triangle's index is its id.")
        .def(py::init(&scene_of), arg("positions"), arg("triangles"), py::kw_only(), arg("uv") = py::none(),
             arg("texture") = py::none(), arg("name") = "scene",
             "positions: float32 (n, 3), world space. triangles: uint32 (m, 3), indices of positions.\n"
             "uv: float32 (n, 2), v down; texture: uint8 (height, width, 4), sRGB, which repeats. All are "
             "copied.\n"
             "Raises ValueError for another dtype, shape, order or byte order, an index beyond the "
             "positions, and\n"
             "positions that are not judged (NaN, infinity, beyond 1e11).")
        .def_property_readonly("name", &Scene::name)
        .def_property_readonly("views", &views_of, "The file's views by name.")
        .def_property_readonly("notes", &Scene::notes, "What loading left out, one line each.")
        .def_property_readonly("vertex_count", &Scene::vertex_count)
        .def_property_readonly("triangle_count", &Scene::triangle_count)
        .def_property_readonly(
            "positions",
            [](const py::object& self) { return threes(self.cast<const Scene&>().positions_world(), self); },
            "float32 (n, 3), read-only, not copied")
        .def_property_readonly(
            "triangles",
            [](const py::object& self) { return threes(self.cast<const Scene&>().triangles(), self); },
            "uint32 (m, 3), read-only, not copied")
        .def("__repr__", &text_of);
    module.def(
        "load",
        [](const py::object& file, const py::object& size) {
            const std::string name = path_from(file);
            const api::Size pixels = size_from(size);
            const py::gil_scoped_release released;
            return Scene::load(name, pixels);
        },
        arg("file"), arg("size") = py::make_tuple(1920, 1080),
        "A .gltf, .glb, .obj or .ply file, a view file (.json), or the name of a scene of the suite.\n"
        "size: (width, height) of its views where the file names none. Raises ValueError with file, place "
        "and remedy.");
}

}  // namespace zproof::python
