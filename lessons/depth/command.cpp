#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "lessons/depth/report.h"
#include "lessons/study.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

/// The planes that were asked about; those of the first view where none were.
DepthQuestion question_of(const StudyTask& task) {
    const DepthOptions& options = task.arguments.depth;
    const Camera& camera = task.subjects.front().views.front().camera;
    DepthQuestion question{{options.near.value_or(camera.near_depth), options.far.value_or(camera.far_depth)},
                           options.gap.value_or(0)};
    if (!(question.planes.near > 0 && question.planes.near < question.planes.far))
        throw UsageError{"study depth: --near " + std::to_string(question.planes.near) + " and --far " +
                         std::to_string(question.planes.far) + "; expected 0 < near < far"};
    if (std::isinf(question.planes.far)) question.planes.far = 1e6 * question.planes.near;
    return question;
}

document::Document perform_depth_study(const StudyTask& task) {
    const DepthQuestion question = question_of(task);
    const auto announce = [&](const std::string& what) { task.progress.begin(what); };
    task.progress.expect_more(study::depth::units_of_gaps());
    document::Document document = depth_document(study::depth::study_gaps(announce), question);
    each_view(task, [&](const StudiedView& one) {
        if (one.view.camera.projection == Projection::parallel) {
            document.sections.push_back({one.title,
                                         {"Left out: in a parallel projection depth is affine in the image, "
                                          "and every format but the hyperbolic ones holds it evenly."},
                                         {}});
            return;
        }
        auto sections = depth_sections(study::depth::study_depth(one.scene, one.view, announce), one.stem);
        std::ranges::move(sections, std::back_inserter(document.sections));
    });
    return document;
}

void add_depth_options(CLI::App& app, StudyArguments& arguments) {
    app.add_option("--near", arguments.depth.near,
                   "which format to choose is asked for these planes; default: the first view's");
    app.add_option("--far", arguments.depth.far, "likewise");
    app.add_option("--gap", arguments.depth.gap, "and for this gap between surfaces, scene units");
}

}  // namespace

Study depth_study() {
    return {.name = "depth",
            .purpose = "what a depth buffer keeps: errors, smallest gaps, and which format to choose",
            .subjects = {"depth_range"},
            .resolution = {480, 270},
            .units_per_view = study::depth::units_of_depth(),
            .add_options = add_depth_options,
            .perform = perform_depth_study};
}

}  // namespace zproof
