#include "python/arrays.h"

namespace zproof::python {
namespace {

std::string shape_text(const py::array& array) {
    std::string text;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(array.shape(i));
    return "(" + text + (array.ndim() == 1 ? ",)" : ")");
}

std::string came(const py::array& array) {
    return py::str(static_cast<const py::object&>(array.dtype())).cast<std::string>() + " " +
           shape_text(array);
}

[[noreturn]] void refuse(const Wanted& wanted, const std::string& came, const std::string& remedy) {
    throw py::value_error(wanted.name + " is " + came + "; expected " + wanted.meaning +
                          (remedy.empty() ? "" : ": " + remedy));
}

std::string type_name(const py::object& object) { return py::str(py::type::of(object).attr("__name__")); }

/// An array of whatever can be asked for one without a copy.
py::array as_array(const py::object& object, const Wanted& wanted) {
    if (py::isinstance<py::array>(object)) return py::reinterpret_borrow<py::array>(object);
    const py::module_ numpy = py::module_::import("numpy");
    const std::string type = type_name(object);
    try {
        if (py::hasattr(object, "__array__") || py::hasattr(object, "__array_interface__"))
            return numpy.attr("asarray")(object);
        if (py::hasattr(object, "__dlpack__")) return numpy.attr("from_dlpack")(object);
    } catch (py::error_already_set& e) {
        if (!e.matches(PyExc_Exception) || e.matches(PyExc_MemoryError)) throw;
        refuse(wanted, "a " + type + " that gives no array (" + std::string(py::str(e.value())) + ")",
               "a tensor on a GPU or with a gradient is first .detach().cpu()");
    }
    refuse(wanted, "a " + type, "an array, or a tensor with __array__ or __dlpack__");
}

bool has_shape(const py::array& array, const std::vector<py::ssize_t>& shape) {
    if (array.ndim() != py::ssize_t(shape.size())) return false;
    for (std::size_t i = 0; i < shape.size(); ++i)
        if (shape[i] >= 0 && array.shape(py::ssize_t(i)) != shape[i]) return false;
    return true;
}

/// What makes the dtype one that is wanted, where something does.
std::string remedy_for(const py::array& array, const py::dtype& dtype) {
    const bool swapped = array.dtype().kind() == dtype.kind() && array.itemsize() == dtype.itemsize();
    const auto name = dtype.attr("name").cast<std::string>();
    return (swapped ? "its byte order is not this machine's; " : std::string()) + ".astype(numpy." + name +
           ")";
}

}  // namespace

std::string path_from(const py::object& object) {
    return py::str(py::module_::import("os").attr("fsdecode")(object));
}

api::Size size_from(const py::object& object) {
    try {
        const auto [width, height] = object.cast<std::pair<int, int>>();
        return {width, height};
    } catch (const py::cast_error&) {
        throw py::value_error("size is " + std::string(py::repr(object)) +
                              "; expected (width, height), whole numbers of pixels");
    }
}

py::dict views_of(const api::Scene& scene) {
    py::dict views = py::module_::import("zproof.judging").attr("_Views")();
    for (const api::View& view : scene.views()) views[py::str(view.name())] = view;
    return views;
}

const api::Scene& scene_from(const py::object& object) {
    if (py::isinstance<api::Scene>(object)) return object.cast<const api::Scene&>();
    throw py::type_error("scene is a " + type_name(object) +
                         "; expected a zproof.Scene, such as zproof.load() gives");
}

const api::View& view_from(const py::object& object, const api::Scene& scene) {
    if (py::isinstance<api::View>(object)) return object.cast<const api::View&>();
    throw py::type_error("view is a " + type_name(object) + "; expected a zproof.View" +
                         views_of(scene).attr("example")(object).cast<std::string>());
}

template <class T>
py::array_t<T, py::array::c_style> array_from(const py::object& object, const Wanted& wanted) {
    using Array = py::array_t<T, py::array::c_style>;
    const py::array array = as_array(object, wanted);
    if (py::hasattr(array, "mask"))
        refuse(wanted, "a masked array", ".filled(value) says what stands where it is masked");
    const py::dtype dtype = py::dtype::of<T>();
    if (!array.dtype().attr("__eq__")(dtype).cast<bool>())
        refuse(wanted, came(array), remedy_for(array, dtype));
    if (!has_shape(array, wanted.shape)) refuse(wanted, came(array), "");
    const bool is_contiguous = (array.flags() & py::array::c_style) != 0;
    const bool is_aligned = reinterpret_cast<std::uintptr_t>(array.data()) % alignof(T) == 0;
    if (!is_contiguous || !is_aligned)
        refuse(wanted, came(array) + (is_contiguous ? ", not aligned" : ", not C-contiguous"),
               "numpy.ascontiguousarray() copies it");
    return py::reinterpret_borrow<Array>(array);
}

template py::array_t<float, py::array::c_style> array_from<float>(const py::object&, const Wanted&);
template py::array_t<std::uint32_t, py::array::c_style> array_from<std::uint32_t>(const py::object&,
                                                                                  const Wanted&);
template py::array_t<std::uint8_t, py::array::c_style> array_from<std::uint8_t>(const py::object&,
                                                                                const Wanted&);
template py::array_t<double, py::array::c_style> array_from<double>(const py::object&, const Wanted&);

}  // namespace zproof::python
