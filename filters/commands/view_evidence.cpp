#include "filters/commands/view_evidence.h"

#include <algorithm>

#include "filters/commands/study_method.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/report/inspection_json.h"
#include "filters/study/inspection.h"
#include "filters/study/study.h"
#include "frame/number_text.h"
#include "program/shell_line.h"
#include "program/usage_error.h"

namespace zproof {
namespace {

constexpr std::size_t most_inspections = 120;  ///< in a view, without those of claimed methods

constexpr std::size_t most_told = std::size_t{1} << 15;  ///< pixels of a box, each method counted
constexpr int rows_at_once = 16;                         ///< for which a method makes its images once

/// The pixel farthest outside what is permitted; none where all are inside.
std::vector<PixelCoord> farthest_outside(const ClaimedPicture& claimed) {
    std::vector<PixelCoord> farthest;
    double most = 0;
    for (int y = 0; y < claimed.picture.size().height; ++y)
        for (int x = 0; x < claimed.picture.size().width; ++x) {
            const double distance =
                distance_outside(claimed.picture.at(x, y), claimed.permitted.least.at(x, y),
                                 claimed.permitted.greatest.at(x, y));
            if (distance > most) most = distance, farthest = {{x, y}};
        }
    return farthest;
}

/// Adds what the method reads at pixels of which that is not told yet.
void tell(std::vector<study::PixelInspection>& all, const study::Inspector& inspector,
          const study::StudyMethod& method, std::vector<PixelCoord> pixels) {
    std::erase_if(pixels, [&](const PixelCoord& pixel) {
        return std::ranges::any_of(all, [&](const study::PixelInspection& one) {
            return one.label == method.label && one.x == pixel.x && one.y == pixel.y;
        });
    });
    std::ranges::move(inspector.at(method, pixels), std::back_inserter(all));
}

}  // namespace

void refuse_unfit_box(const CropBox& box, std::size_t methods, const View& view) {
    if (box.x + box.width > view.width || box.y + box.height > view.height)
        throw UsageError{"--inspect: " + in_words(box) + " reaches beyond the view '" + view.name +
                         "', which has " + size_text(view.width, view.height) + " pixels"};
    const std::size_t told = std::size_t(box.width) * std::size_t(box.height) * methods;
    if (told > most_told)
        throw UsageError{"--inspect: " + in_words(box) + " has " + std::to_string(told) +
                         " pixels, each method counted; at most " + std::to_string(most_told)};
}

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

void ViewEvidenceWriter::claim(const ClaimedPicture& claimed) {
    if (!planes_) return;
    planes_->add_claim(claimed);
    std::ranges::copy(farthest_outside(claimed), std::back_inserter(worst_.back().by_region.front()));
}

void ViewEvidenceWriter::map(const std::string& label, const PictureMetric& metric,
                             const Plane<double>& map) {
    if (planes_ && metric.name == "flip") planes_->add_flip(label, map);
}

std::vector<study::StudyMethod> ViewEvidenceWriter::told_methods(const StudiedView& studied) const {
    std::vector<study::StudyMethod> told;
    const auto add = [&](const study::StudyMethod& method) {
        if (std::ranges::find(told, method.label, &study::StudyMethod::label) == told.end())
            told.push_back(method);
    };
    for (const study::MethodPixels& shown : worst_) {
        const PictureClaim* const claim = find_claim(studied.pictures, shown.label);
        if (claim)
            add(study_method(claim->method));
        else if (const auto method =
                     std::ranges::find(studied.plan.methods, shown.label, &study::StudyMethod::label);
                 method != studied.plan.methods.end())
            add(*method);
    }
    return told;
}

void ViewEvidenceWriter::add_inspected(const study::Inspector& inspector, const StudiedView& studied,
                                       const CropBox& box) {
    for (const study::StudyMethod& method : told_methods(studied))
        for (int first = box.y; first < box.y + box.height; first += rows_at_once) {
            const int last = std::min(first + rows_at_once, box.y + box.height);
            std::vector<PixelCoord> pixels;
            for (int y = first; y < last; ++y)
                for (int x = box.x; x < box.x + box.width; ++x) pixels.push_back({x, y});
            const std::vector<study::PixelInspection> told = inspector.at(method, pixels);
            for (int y = first; y < last; ++y) {
                const auto begin = told.begin() + std::ptrdiff_t(y - first) * box.width;
                planes_->add_inspected_row(method.label, y, to_json({begin, begin + box.width}));
            }
        }
}

nlohmann::json ViewEvidenceWriter::inspections(const study::Inspector& inspector,
                                               const StudiedView& studied) const {
    std::vector<study::PixelInspection> all;
    for (const study::ChosenPixels& chosen : study::chosen_pixels(worst_, most_inspections)) {
        const auto method = std::ranges::find(studied.plan.methods, chosen.label, &study::StudyMethod::label);
        if (method != studied.plan.methods.end()) tell(all, inspector, *method, chosen.pixels);
        if (const PictureClaim* claim = find_claim(studied.pictures, chosen.label))
            tell(all, inspector, study_method(claim->method), chosen.pixels);
    }
    return to_json(all);
}

void ViewEvidenceWriter::write(const std::filesystem::path& folder, const StudiedView& studied) && {
    if (!planes_) return;
    const FilterViewFacts facts{.scene = studied.scene_name,
                                .view = studied.view.name,
                                .truth = oracle::letters_of(studied.plan.truth),
                                .explain = explain_command_for(studied)};
    const Frame frame = oracle::exact_visibility(studied.scene, studied.view);
    const study::Inspector inspector(studied.scene, studied.view, frame, studied.plan.truth);
    if (studied.inspected) add_inspected(inspector, studied, *studied.inspected);
    planes::write(folder / "planes.zvp",
                  std::move(*planes_).container(facts, inspections(inspector, studied)));
}

std::string explain_command_for(const StudiedView& studied) {
    const View& view = studied.view;
    return "zproof filters explain " + shell_quoted(studied.scene_word) + " --view " +
           shell_quoted(view.name) + " --width " + std::to_string(view.width) + " --height " +
           std::to_string(view.height) + " --truth " + oracle::letters_of(studied.plan.truth);
}

}  // namespace zproof
