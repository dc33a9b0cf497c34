#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <optional>

#include "lessons/projection/border_lattice.h"
#include "lessons/projection/sections.h"
#include "lessons/study.h"
#include "oracle/embree.h"
#include "oracle/oracle_error.h"
#include "oracle/povray.h"
#include "program/interrupt.h"
#include "rasterizer/rasterizer.h"
#include "rasterizer/shader.h"
#include "reports/pictures.h"

namespace zproof {
namespace {

using namespace study::projection;

/// More than the lattice has.
constexpr std::size_t most_lattice = 100'000;

/// POV-Ray reads its scene as text: larger ones take minutes.
constexpr std::size_t most_povray_triangles = 100'000;
constexpr std::chrono::seconds povray_time_limit{60};

bool names_triangles(const Frame& frame, const Scene& scene) {
    return std::ranges::all_of(frame.primitive.pixels(), [&](PrimitiveId id) {
        return id == PrimitiveId::none || std::size_t(id) < scene.triangles.size();
    });
}

/// Somebody's frame held against the wireframe.
void compare(const StudiedView& one, const std::string& name, const Frame& frame, const Precision& precision,
             ProjectedView& found) {
    if (!names_triangles(frame, one.scene)) {
        found.absences.push_back(
            name + " names triangles that the scene does not have: its edges are not measured.");
        return;
    }
    found.agreements.push_back(edge_agreement(one.scene, one.view, frame.primitive, precision));
    found.agreements.back().renderer = name;
}

void ask_povray(const StudiedView& one, ProjectedView& found) {
    if (one.scene.triangles.size() > most_povray_triangles) {
        found.absences.push_back("POV-Ray was not asked: more than " + std::to_string(most_povray_triangles) +
                                 " triangles.");
        return;
    }
    try {
        const oracle::PovRay povray{one.scene, {.time_limit = povray_time_limit}};
        compare(one, "POV-Ray", povray.render(one.view), oracle::povray_precision(), found);
        found.pictures.push_back({"POV-Ray", picture_of_light(povray.picture(one.view, Light{}))});
    } catch (const OracleError& e) {
        found.absences.push_back(std::string{"POV-Ray: "} + e.what());
    }
}

ProjectedView projected(const StudiedView& one, const StudyTask& task, const oracle::Embree& embree) {
    ProjectedView found;
    found.title = one.title, found.stem = one.stem, found.size = {one.view.width, one.view.height};
    task.progress.begin("vertices");
    found.accuracy = accuracy_of(one.scene, one.view, std::size_t(task.arguments.projection.vertices));
    task.progress.begin("wireframe");
    const Frame frame = rasterizer::render(one.scene, one.view);
    found.wireframe = split_by_visibility(wireframe_of(one.scene, one.view), frame.primitive);
    found.ids = picture_of_ids(frame.primitive);
    compare(one, "zproof", frame, rasterizer::precision(), found);
    found.pictures.push_back(
        {"zproof", picture_of_light(rasterizer::shade(one.scene, one.view, frame, Light{}))});
    task.progress.begin("Embree, POV-Ray");
    compare(one, "Embree", embree.trace(one.view), oracle::embree_precision(), found);
    if (task.arguments.projection.oracles == StudyOracles::all) ask_povray(one, found);
    return found;
}

document::Document perform_projection_study(const StudyTask& task) {
    std::vector<ProjectedView> views;
    std::optional<oracle::Embree> embree;
    const Scene* shown_to_embree = nullptr;
    each_view(task, [&](const StudiedView& one) {
        if (shown_to_embree != &one.scene) embree.emplace(one.scene);
        shown_to_embree = &one.scene;
        views.push_back(projected(one, task, *embree));
    });
    document::Document document{
        .title = "The projection, stage by stage",
        .command = "",
        .version = "",
        .introduction = projection_introduction(views),
        .sections = {lesson_section(),
                     border_section(accuracy_of(border_lattice(), lattice_view(), most_lattice))}};
    for (const ProjectedView& view : views) {
        document.sections.push_back(vertex_section(view));
        document.sections.push_back(wireframe_section(view));
    }
    return document;
}

void add_projection_options(CLI::App& app, StudyArguments& arguments) {
    app.add_option("--vertices", arguments.projection.vertices, "at most so many are studied, evenly spread")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    app.add_flag_callback(
        "--without-povray", [&arguments] { arguments.projection.oracles = StudyOracles::embree; },
        "compare with Embree only");
}

}  // namespace

Study projection_study() {
    return {.name = "projection",
            .purpose = "every stage from world to raster space, against exact arithmetic; the wireframe",
            .subjects = {"room", "far_from_origin"},
            .resolution = {960, 540},
            .units_per_view = 3,
            .add_options = add_projection_options,
            .perform = perform_projection_study};
}

}  // namespace zproof
