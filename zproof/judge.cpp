#include <algorithm>

#include "compare/judge.h"
#include "compare/labels/labelled_frame.h"
#include "frame/joined.h"
#include "frame/number_text.h"
#include "frame/precision_presets.h"
#include "frame/precision_text.h"
#include "frame/printable.h"
#include "scenes/judged_ranges.h"
#include "scenes/triangle_labels.h"
#include "zproof/data.h"
#include "zproof/errors.h"
#include "zproof/finding.h"
#include "zproof/ids.h"
#include "zproof/names.h"

namespace zproof::api {
namespace {

void require_length(const char* what, std::size_t length, const View& view) {
    const std::size_t pixels = view.size().pixel_count();
    if (length == 0 || length == pixels) return;
    throw InputError{std::string("judge: ") + what + " has " + std::to_string(length) + " values; view '" +
                     view.name() + "' has " + size_text(view.size().width, view.size().height) + " = " +
                     std::to_string(pixels)};
}

/// A word for ids, or a file of labels.
void require_ids(const std::string& ids) {
    require_no_nul("judge: ids", ids);
    if (const std::string fault = fault_of_label_word(ids); !fault.empty())
        throw InputError{"judge: ids " + one_line(ids) + ": " + fault};
}

std::string preset_names() { return joined(precision_presets(), ", ", &PrecisionPreset::name); }

Declared declared(const Scene& scene, const Candidate& candidate) {
    if (candidate.id.empty() && candidate.depth.empty())
        throw InputError{"judge: neither ids nor depths; expected at least one of them"};
    require_no_nul("judge: precision", candidate.precision);
    require_ids(candidate.ids);
    if (candidate.precision.empty())
        throw InputError{"judge: no precision; expected what the renderer promises: a preset (" +
                         preset_names() + "), words like 'raster,subpixel_bits=4', or a file"};
    Declared declared{.precision_word = candidate.precision,
                      .ids = candidate.id.empty() ? "none" : candidate.ids,
                      .precision = precision_from_word(candidate.precision),
                      .labels = nullptr,
                      .has_depth = !candidate.depth.empty()};
    if (declared.ids != "triangle")
        declared.labels = std::make_shared<TriangleLabels>(label_triangles(declared.ids, scene.data().scene));
    if (declared.labels && !declared.has_depth)
        throw InputError{"judge: ids of " + declared.ids + "s without depths; expected depths beside them"};
    return declared;
}

/// The candidate's arrays, without a copy; what is not given stays empty.
zproof::Frame lent_frame(const Candidate& candidate, Resolution size) {
    zproof::Frame frame;
    if (!candidate.id.empty())
        frame.primitive = Plane<PrimitiveId>::lent(
            size, reinterpret_cast<const PrimitiveId*>(candidate.id.data()));  // NOLINT: the enum's own type
    if (!candidate.depth.empty()) frame.camera_depth = Plane<float>::lent(size, candidate.depth.data());
    return frame;
}

/// What the judge takes: triangles and depths. Ids alone promise no depth.
zproof::Frame judged_frame(Verdict::Data& data) {
    const zproof::Scene& scene = data.scene.data().scene;
    const zproof::View& view = data.view.data().view;
    auto& [word, ids, precision, labels, has_depth] = data.declared;
    if (!has_depth) {
        zproof::Frame with_depths = with_own_depths(scene, view, data.given.primitive, precision);
        with_depths.primitive = lent_frame({.id = ids_of(data.given)}, with_depths.size()).primitive;
        precision = with_any_depth(precision, view, with_depths);
        return with_depths;
    }
    if (!labels)
        return lent_frame({ids_of(data.given), data.given.camera_depth.pixels(), {}, {}},
                          {view.width, view.height});
    zproof::Frame of_labels = data.given;
    if (labels->are_absent) of_labels.primitive = Plane<PrimitiveId>(of_labels.camera_depth.size());
    zproof::Frame of_triangles =
        with_triangles(scene, view, {of_labels, precision}, *labels, reference_of(data));
    of_triangles.camera_depth =
        Plane<float>::lent(of_labels.camera_depth.size(), data.given.camera_depth.pixels().data());
    return of_triangles;
}

}  // namespace

Verdict judge(const Scene& scene, const View& view, const Candidate& candidate) {
    return told_as_input_error([&] {
        require_length("id", candidate.id.size(), view);
        require_length("depth", candidate.depth.size(), view);
        Declared promise = declared(scene, candidate);
        auto data = std::make_shared<Verdict::Data>(
            Verdict::Data{.scene = scene,
                          .view = view,
                          .declared = std::move(promise),
                          .given = lent_frame(candidate, {view.size().width, view.size().height}),
                          .judged = {},
                          .reference = trace(scene, view),
                          .verdict = {},
                          .findings = {}});
        data->judged = judged_frame(*data);
        data->verdict = zproof::judge(scene.data().scene, view.data().view, candidate_of(*data),
                                      reference_of(*data), {.findings = JudgeOptions::Findings::differences});
        data->findings.reserve(data->verdict.findings.size());
        for (const zproof::Finding& finding : data->verdict.findings)
            data->findings.push_back(plain(finding));
        return Verdict{std::shared_ptr<const Verdict::Data>{std::move(data)}};
    });
}

}  // namespace zproof::api
