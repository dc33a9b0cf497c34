/// The module's parts.
#pragma once

#include <pybind11/pybind11.h>

namespace zproof::python {

void bind_view(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_frame(pybind11::module_& module);
void bind_verdict(pybind11::module_& module);
void bind_filters(pybind11::module_& module);

}  // namespace zproof::python
