#include "python/bindings.h"

#include "zproof/zproof.h"

namespace {

/// An object without a value, as __new__ would make one, is refused: only functions of the module make them.
void refuse_new(pybind11::module_& module, const char* name) {
    namespace py = pybind11;
    const std::string text = std::string("zproof.") + name + " is made by functions of zproof only";
    const py::cpp_function refuse(
        [text](const py::args&, const py::kwargs&) -> py::object { throw py::type_error(text); });
    module.attr(name).attr("__new__") = py::staticmethod(refuse);
}

}  // namespace

// zproof._zproof: the C++ interface as it is. What Python adds to it stands in python/zproof.
PYBIND11_MODULE(_zproof, module) {
    namespace py = pybind11;
    using namespace zproof;
    py::register_exception<api::InputError>(module, "InputError", PyExc_ValueError);
    module.attr("BACKGROUND_ID") = py::int_(api::background_id);
    module.attr("__version__") = std::string(api::version());
    python::bind_view(module);
    python::bind_scene(module);
    python::bind_frame(module);
    python::bind_verdict(module);
    python::bind_filters(module);
    for (const char* name :
         {"View", "Frame", "Verdict", "Finding", "Explanation", "NearTriangle", "Diagnosis"})
        refuse_new(module, name);
}
