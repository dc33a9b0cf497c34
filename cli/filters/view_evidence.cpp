#include "cli/filters/view_evidence.h"

#include <algorithm>

#include "cli/arguments.h"
#include "oracle/admissible_surfaces.h"
#include "reports/filters/inspection_json.h"
#include "study/filters/inspection.h"
#include "study/filters/study.h"

namespace zproof {

namespace {

constexpr std::size_t most_inspections = 120;  ///< in a view

}  // namespace

void ViewEvidenceWriter::begin(const study::ViewEvidence& known) {
    planes_.emplace(known);
    truth_ = known.truth;
    regions_ = known.regions;
}

void ViewEvidenceWriter::show(const std::string& what, const Picture& picture) {
    if (!planes_) return;
    planes_->add_picture(what, picture);
    worst_.push_back({what, study::worst_pixels(picture, truth_, regions_)});
}

void ViewEvidenceWriter::map(const std::string& label, const PictureMetric& metric,
                             const Plane<double>& map) {
    if (planes_ && metric.name == "flip") planes_->add_flip(label, map);
}

nlohmann::json ViewEvidenceWriter::inspections(const StudiedView& studied) const {
    const Frame frame = oracle::exact_visibility(studied.scene, studied.view);
    const study::Inspector inspector(studied.scene, studied.view, frame, studied.plan.truth);
    std::vector<study::PixelInspection> all;
    for (const study::ChosenPixels& chosen : study::chosen_pixels(worst_, most_inspections)) {
        const auto method =
            std::ranges::find(studied.plan.methods, chosen.label, &study::ConfiguredMethod::label);
        if (method != studied.plan.methods.end())
            std::ranges::move(inspector.at(*method, chosen.pixels), std::back_inserter(all));
    }
    return to_json(all);
}

void ViewEvidenceWriter::write(const std::filesystem::path& folder, const StudiedView& studied) && {
    if (!planes_) return;
    const FilterViewFacts facts{.scene = studied.scene_name,
                                .view = studied.view.name,
                                .truth = study::letter_of(studied.plan.truth),
                                .explain = explain_command_for(studied)};
    planes::write(folder / "planes.zvp", std::move(*planes_).container(facts, inspections(studied)));
}

std::string explain_command_for(const StudiedView& studied) {
    const View& view = studied.view;
    return "zproof filters explain " + shell_quoted(studied.scene_word) + " --view " +
           shell_quoted(view.name) + " --width " + std::to_string(view.width) + " --height " +
           std::to_string(view.height) + " --truth " + study::letter_of(studied.plan.truth);
}

}  // namespace zproof
