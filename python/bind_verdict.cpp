#include <pybind11/stl.h>

#include "python/arrays.h"
#include "python/bindings.h"

namespace zproof::python {
namespace {

using api::Finding;
using api::Scene;
using api::View;

/// A verdict and the arrays that it refers to.
struct JudgedArrays {
    api::Verdict verdict;
    py::object id, depth;
};

std::vector<py::ssize_t> shape_of(const View& view) { return {view.size().height, view.size().width}; }

Wanted aov(const char* name, const char* dtype, const View& view) {
    const auto shape = shape_of(view);
    return {name, shape,
            std::string(dtype) + " (" + std::to_string(shape[0]) + ", " + std::to_string(shape[1]) +
                "), the view's (height, width)"};
}

JudgedArrays judged(const py::object& of_scene, const py::object& of_view, const py::object& id,
                    const py::object& depth, const std::string& precision, const std::string& ids) {
    const Scene& scene = scene_from(of_scene);
    const View& view = view_from(of_view, scene);
    api::Candidate candidate{.precision = precision, .ids = ids};
    JudgedArrays kept{api::Verdict{nullptr}, py::none(), py::none()};
    if (!id.is_none()) {
        const auto array = array_from<std::uint32_t>(id, aov("id", "uint32", view));
        candidate.id = values_of(array);
        kept.id = array;
    }
    if (!depth.is_none()) {
        const auto array = array_from<float>(depth, aov("depth", "float32", view));
        candidate.depth = values_of(array);
        kept.depth = array;
    }
    const py::gil_scoped_release released;
    kept.verdict = api::judge(scene, view, candidate);
    return kept;
}

py::dict counts_of(const JudgedArrays& self) {
    py::dict counts;
    const auto names = api::class_names();
    for (std::size_t i = 0; i < names.size(); ++i)
        counts[py::str(std::string(names[i]))] = py::int_(self.verdict.counts()[i]);
    return counts;
}

template <class T>
py::array plane_of(const py::object& self, std::span<const T> (api::Verdict::*values)() const) {
    const api::Verdict& verdict = self.cast<const JudgedArrays&>().verdict;
    return array_of((verdict.*values)(), shape_of(verdict.view()), self);
}

/// A finding's numbers as numpy has them.
py::dtype finding_dtype() {
    py::list names, formats, offsets;
    constexpr Finding zero{};
    const auto add = [&](const auto& field) {
        const auto& number = zero.*field.second;
        names.append(field.first);
        formats.append(py::dtype::of<std::remove_cvref_t<decltype(number)>>());
        offsets.append(reinterpret_cast<const char*>(&number) - reinterpret_cast<const char*>(&zero));
    };
    std::apply([&](const auto&... field) { (add(field), ...); }, api::finding_fields);
    return {names, formats, offsets, sizeof(Finding)};
}

py::array findings_of(const py::object& self) {
    const std::span<const Finding> findings = self.cast<const JudgedArrays&>().verdict.findings();
    py::array array(finding_dtype(), py::ssize_t(findings.size()), findings.data(), self);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

py::object worst_of(const JudgedArrays& self) {
    const auto worst = self.verdict.worst();
    return worst ? py::cast(*worst) : py::none();
}

std::string text_of(const JudgedArrays& self) {
    const std::string what = self.verdict.is_proven() ? "proven"
                             : self.verdict.defect_count() > 0
                                 ? std::to_string(self.verdict.defect_count()) + " defects"
                                 : "undecided";
    return "<zproof.Verdict of '" + self.verdict.view().name() + "': " + what + ">";
}

py::list names_of_classes() {
    py::list names;
    for (const std::string_view name : api::class_names()) names.append(std::string(name));
    return names;
}

py::list colours_of_classes() {
    py::list colours;
    for (const std::uint32_t colour : api::class_colours()) colours.append(colour);
    return colours;
}

std::string_view class_name(std::uint32_t pixel_class) { return api::class_names()[pixel_class]; }

void bind_finding(py::module_& module) {
    py::class_<Finding> finding(module, "Finding",
                                "A pixel that does not simply agree; a row of Verdict.findings.");
    const auto bind = [&](const auto& field) {
        if (std::string_view(field.first) != "class") finding.def_readonly(field.first, field.second);
    };
    std::apply([&](const auto&... field) { (bind(field), ...); }, api::finding_fields);
    finding
        .def_property_readonly("class_name",  // class is a keyword of Python
                               [](const Finding& f) { return std::string(class_name(f.pixel_class)); })
        .def_property_readonly(
            "bound",
            [](const Finding& f) { return py::make_tuple(f.depth_low, f.depth_truth, f.depth_high); },
            "(low, truth, high): the depths that the named triangle admits; NaN for background");
}

void bind_explanation(py::module_& module) {
    using Triangle = api::Explanation::Triangle;
    py::class_<Triangle>(module, "NearTriangle", "A triangle that comes near a pixel, as the judge sees it.")
        .def_readonly("id", &Triangle::id)
        .def_property_readonly(
            "bound",
            [](const Triangle& t) { return py::make_tuple(t.depth_low, t.depth_truth, t.depth_high); },
            "(low, truth, high): the depths that it admits there")
        .def_readonly("edge_distance_px", &Triangle::edge_distance_px,
                      "Of the pixel's centre from each edge, positive inside.")
        .def_readonly("is_admissible", &Triangle::is_admissible);
    py::class_<api::Explanation>(module, "Explanation",
                                 "Why a pixel has its class. str() of it is the story.")
        .def_readonly("text", &api::Explanation::text)
        .def_readonly("finding", &api::Explanation::finding)
        .def_readonly("triangles", &api::Explanation::triangles,
                      "Those within eps of the centre, nearest first.")
        .def_readonly("is_background_admissible", &api::Explanation::is_background_admissible)
        .def("__str__", [](const api::Explanation& e) { return e.text; })
        .def("__repr__", [](const api::Explanation& e) { return e.text; });
    py::class_<api::Diagnosis>(module, "Diagnosis", "What one cause would explain. str() of it is one line.")
        .def_readonly("text", &api::Diagnosis::text)
        .def_readonly("cause", &api::Diagnosis::cause, "Empty: none is certain.")
        .def_readonly("explained_share", &api::Diagnosis::explained_share)
        .def_readonly("defects", &api::Diagnosis::defects)
        .def("__str__", [](const api::Diagnosis& d) { return d.text; })
        .def("__repr__", [](const api::Diagnosis& d) { return d.text; });
}

void save(const JudgedArrays& self, const py::object& folder, const std::string& name) {
    const std::string path = path_from(folder);
    const py::gil_scoped_release released;
    api::save(self.verdict, path, name);
}

void save_all(const std::vector<std::pair<std::string, const JudgedArrays*>>& verdicts,
              const py::object& folder) {
    const std::string path = path_from(folder);
    std::vector<api::NamedVerdict> named;
    for (const auto& [name, judged] : verdicts) {
        if (!judged) throw py::value_error("save_all: '" + name + "' is None; expected a Verdict");
        named.push_back({name, judged->verdict});
    }
    const py::gil_scoped_release released;
    api::save(named, path);
}

}  // namespace

void bind_verdict(py::module_& module) {
    using py::arg;
    using released = py::call_guard<py::gil_scoped_release>;
    bind_finding(module);
    bind_explanation(module);
    module.def("is_defect", &api::is_defect, arg("pixel_class"));
    module.attr("CLASS_NAMES") = py::tuple(names_of_classes());
    module.attr("CLASS_COLOURS") = py::tuple(colours_of_classes());
    py::class_<JudgedArrays>(module, "Verdict", "What the judge says of arrays beside Embree's frame.")
        .def_property_readonly(
            "proven", [](const JudgedArrays& self) { return self.verdict.is_proven(); },
            "No defect, and nothing undecidable.")
        .def_property_readonly(
            "defects", [](const JudgedArrays& self) { return self.verdict.defect_count(); },
            "Pixels that fail the gate.")
        .def_property_readonly("counts", &counts_of, "Pixels by the name of their class.")
        .def_property_readonly(
            "classes", [](const py::object& self) { return plane_of(self, &api::Verdict::classes); },
            "uint8 (height, width), read-only: an index of CLASS_NAMES for every pixel")
        .def_property_readonly("findings", &findings_of,
                               "A structured array, read-only: every pixel that is not `agree`, in raster "
                               "order. Its class is an "
                               "index of CLASS_NAMES, is_defect 0 or 1.")
        .def_property_readonly(
            "worst", &worst_of,
            "The defect with the largest error over its bound, as the report ranks them, or None.")
        .def(
            "sentence", [](const JudgedArrays& self, const Finding& f) { return self.verdict.sentence(f); },
            arg("finding"), "One line about a finding.")
        .def(
            "explain", [](const JudgedArrays& self, int x, int y) { return self.verdict.explain(x, y); },
            arg("x"), arg("y"), released(),
            "Why pixel (x, y) has its class. Raises ValueError outside of the view.")
        .def_property_readonly(
            "diagnosis",
            [](const JudgedArrays& self) {
                const py::gil_scoped_release unlocked;
                return self.verdict.diagnosis();
            },
            "What one cause would explain, or None where there is no defect. Takes about as long as the "
            "verdict.")
        .def_property_readonly("scene", [](const JudgedArrays& self) { return self.verdict.scene(); })
        .def_property_readonly("view", [](const JudgedArrays& self) { return self.verdict.view(); })
        .def_property_readonly(
            "reference", [](const JudgedArrays& self) { return self.verdict.reference(); }, "Embree's frame.")
        .def_property_readonly(
            "id", [](const py::object& self) { return plane_of(self, &api::Verdict::judged_id); },
            "uint32 (height, width), read-only: the triangles that were judged; the array itself that was "
            "handed over, "
            "where it holds triangles")
        .def_property_readonly(
            "depth", [](const py::object& self) { return plane_of(self, &api::Verdict::judged_depth); },
            "float32 (height, width), read-only: the depths that were judged; the array itself that was "
            "handed over")
        .def("save", &save, arg("folder"), arg("name") = "",
             "Writes the report of `zproof compare` into the folder: report.html, results.json, junit.xml, "
             "evidence.\n"
             "name: the scene's in the report; default: its own. What the program was given stays in "
             "FOLDER-input. The program is looked for on PATH, or is the "
             "one that\n"
             "ZPROOF_PROGRAM names. A folder that is no report of zproof is never replaced. Raises "
             "RuntimeError with\n"
             "the program's own words.")
        .def("__bool__", [](const JudgedArrays& self) { return self.verdict.is_proven(); })
        .def("__repr__", &text_of);
    module.def("judge", &judged, arg("scene"), arg("view"), arg("id"), arg("depth"), arg("precision"),
               arg("ids"));
    module.def("save_all", &save_all, arg("verdicts"), arg("folder"));
}

}  // namespace zproof::python
