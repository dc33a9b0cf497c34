/// Arrays of others, looked at before they are used: nothing is converted, and nothing copied that need not
/// be.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <vector>

#include "zproof/zproof.h"

namespace zproof::python {

namespace py = pybind11;

/// What an argument must be.
struct Wanted {
    std::string name;                ///< of the argument
    std::vector<py::ssize_t> shape;  ///< -1: any length
    std::string meaning;             ///< "uint32 (height, width)"
};

/// A path, of a str, bytes or an os.PathLike.
std::string path_from(const py::object& object);

/// (width, height), whole numbers. Throws ValueError for anything else.
api::Size size_from(const py::object& object);

/// The scene, or the view of that scene, that was handed over. Throws TypeError that says what came instead.
const api::Scene& scene_from(const py::object& object);
const api::View& view_from(const py::object& object, const api::Scene& scene);

/// The scene's views by name: zproof.judging's dict, which says what is there where a name is not.
py::dict views_of(const api::Scene& scene);

/// A C-contiguous array of T in this machine's byte order. The object may be an array, or whatever hands out
/// one by __array__ or DLPack. Throws ValueError that names what came and what is wanted.
template <class T>
py::array_t<T, py::array::c_style> array_from(const py::object& object, const Wanted& wanted);

template <class T>
std::span<const T> values_of(const py::array_t<T, py::array::c_style>& array) {
    return {array.data(), std::size_t(array.size())};
}

/// A read-only array of memory that `owner` keeps alive.
template <class T>
py::array_t<T> array_of(std::span<const T> values, std::vector<py::ssize_t> shape, const py::object& owner) {
    py::array_t<T> array(std::move(shape), values.data(), owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

}  // namespace zproof::python
