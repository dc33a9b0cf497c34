#include "python/bindings.h"

#include "zproof/zproof.h"

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
}
