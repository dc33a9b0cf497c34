#include "lessons/shading/report.h"
#include "lessons/study.h"

namespace zproof {
namespace {

constexpr int most_levels = 6, side_px = 256;

document::Document perform_shading_study(const StudyTask& task) {
    const auto announce = [&](const std::string& what) { task.progress.begin(what); };
    task.progress.expect_more(1);
    announce("a sphere");
    const View view = study::shading::sphere(0, side_px).views.front();
    document::Document document = shading_document(study::shading::study_tessellation(
        study::shading::lighting_of(view, study::shading::Highlight::phong), most_levels, side_px));
    each_view(task, [&](const StudiedView& one) {
        document.sections.push_back(
            shading_section(study::shading::study_shading(one.scene, one.view, announce), one.stem));
    });
    return document;
}

}  // namespace

Study shading_study() {
    return {.name = "shading",
            .purpose = "faceted, Gouraud and Phong against the truth: highlights, Mach bands, affine errors",
            .subjects = {"closed_surfaces"},
            .resolution = {480, 270},
            .units_per_view = study::shading::units_of_shading(),
            .add_options = {},
            .perform = perform_shading_study};
}

}  // namespace zproof
