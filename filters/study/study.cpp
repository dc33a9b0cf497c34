#include "filters/study/study.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "filters/metrics/picture_metric.h"
#include "filters/reference/admissible_surfaces.h"
#include "filters/study/cost.h"
#include "filters/study/scores.h"

namespace zproof::study {

namespace {

constexpr std::size_t most_lookups = 1 << 16;  ///< counted and timed

/// A view, and the same a fraction of a pixel further on: what all methods have in common.
struct Pan {
    std::vector<View> views;
    std::vector<Frame> frames;
    std::vector<LinearPicture> truths;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Picture in_float(const LinearPicture& light) {
    Picture picture(light.size());
    for (std::size_t i = 0; i < light.pixels().size(); ++i) {
        const glm::vec3 c{light.pixels()[i]};
        picture.pixels()[i] = {c.r, c.g, c.b};
    }
    return picture;
}

/// Textured and interior in every view of the pan; the first has the regions.
Plane<std::uint8_t> steady_mask(const Scene& scene, const Pan& pan,
                                const std::vector<Plane<oracle::TruthKind>>& around) {
    Plane<std::uint8_t> mask(pan.frames[0].size(), 1);
    for (std::size_t k = 0; k < pan.frames.size(); ++k) {
        const Plane<Patch> patches = surface_map(scene, pan.views[k], pan.frames[k]);
        for (std::size_t i = 0; i < mask.pixels().size(); ++i)
            if (!patches.pixels()[i].is_textured() || around[k].pixels()[i] != oracle::TruthKind::interior)
                mask.pixels()[i] = 0;
    }
    return mask;
}

/// The plane with `value` in the rows above the first that counts.
template <class T>
Plane<T> from_row(Plane<T> plane, int first_row, T value) {
    for (int y = 0; y < std::min(first_row, plane.size().height); ++y) std::ranges::fill(plane.row(y), value);
    return plane;
}

/// One view under study.
class MeasuredView {
  public:
    MeasuredView(const Scene& scene, const View& view, const Plan& plan, const ProgressSink& progress_sink)
        : scene_(scene), metrics_(picture_metrics(plan.light)), textures_(source_textures(scene)) {
        const auto counted_rows = [&](Plane<oracle::TruthKind> kinds) {
            return from_row(std::move(kinds), plan.first_row, oracle::TruthKind::background);
        };
        std::vector<Plane<oracle::TruthKind>> around;
        Plane<oracle::TruthKind> truth_kinds;
        for (int step = 0; step <= plan.flicker_steps; ++step) {
            progress_sink.begins(step == 0 ? "truth" : "truth, moved by step " + std::to_string(step),
                                 work_of_truths(plan) / (1 + plan.flicker_steps));
            pan_.views.push_back(shifted(view, step * flicker_step_x_px, step * flicker_step_y_px));
            pan_.frames.push_back(oracle::exact_visibility(scene, pan_.views.back()));
            const auto start = std::chrono::steady_clock::now();
            oracle::AreaTruth truth = oracle::area_truth(scene, pan_.views.back(), plan.truth);
            if (step == 0) truth_seconds_ = seconds_since(start);
            if (step == 0) half_width_ = truth.half_width;
            if (step == 0) truth_kinds = counted_rows(std::move(truth.kind));
            around.push_back(counted_rows(oracle::surfaces_around(scene, pan_.views.back())));
            pan_.truths.push_back(std::move(truth.mean));
        }
        patches_ = surface_map(scene, view, pan_.frames[0]);
        regions_ = regions(patches_, around[0], truth_kinds);
        steady_ = steady_mask(scene, pan_, around);
        Frame counted = pan_.frames[0];
        counted.primitive = from_row(std::move(counted.primitive), plan.first_row, PrimitiveId::none);
        lookups_ = lookups(scene, view, counted, most_lookups);
    }

    MethodScore score(const StudyMethod& method, const ProgressSink& progress_sink) const {
        std::vector<LinearPicture> pictures;
        const bool is_still = method.views == StudyMethod::Views::still;
        for (std::size_t k = 0; k < (is_still ? 1 : pan_.views.size()); ++k) {
            const Picture picture = painted(method, k);
            if (k == 0) progress_sink.is_shown(method.label, picture);
            pictures.push_back(in_double(picture));
        }
        const auto visit = [&](const PictureMetric& metric, const Plane<double>& map) {
            if (progress_sink.is_mapped) progress_sink.is_mapped(method.label, metric, map);
        };
        return {.label = method.label,
                .regions = scores(pictures[0], pan_.truths[0], half_width_, regions_, {metrics_, visit}),
                .cost = cost(method),
                .flicker = flicker(pictures, pan_.truths, steady_),
                .file = {}};
    }

    Picture truth() const { return in_float(pan_.truths[0]); }
    ViewEvidence evidence() const { return {truth(), half_width_, patches_, regions_}; }
    double truth_seconds() const { return truth_seconds_; }
    std::string texture_sizes() const { return sizes_of(textures_); }

  private:
    Picture painted(const StudyMethod& method, std::size_t k) const {
        if (method.paint) return method.paint(scene_, pan_.views[k], pan_.frames[k]);
        return rasterizer::filtered(scene_, pan_.views[k], pan_.frames[k], method.texturing);
    }

    /// Nobody counts what a sampler of others reads.
    Cost cost(const StudyMethod& method) const {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        if (!method.paint) return cost_of(method.texturing, textures_, lookups_);
        return {.texels = unknown,
                .lines = unknown,
                .build_ms = unknown,
                .ns_per_sample = unknown,
                .pixels = lookups_.size()};
    }

    const Scene& scene_;
    std::span<const PictureMetric> metrics_;
    SourceTextures textures_;
    Pan pan_;
    Plane<double> half_width_;
    Plane<Patch> patches_;
    std::vector<Region> regions_;
    Plane<std::uint8_t> steady_;
    std::vector<Lookup> lookups_;
    double truth_seconds_ = 0;
};

}  // namespace

StudyResults begun(const Plan& plan) {
    StudyResults results;
    results.truth = oracle::letters_of(plan.truth);
    for (const PictureMetric& m : picture_metrics(plan.light))
        results.metrics.push_back({std::string{m.name}, std::string{m.definition}, std::string{m.source},
                                   m.better == Better::higher, m.decimals});
    results.regions = region_cards();
    for (const StudyMethod& c : plan.methods) {
        const texture::DefinitionCard& card = c.texturing.method.card;
        results.methods.push_back({c.label, card.footprint, card.lod, card.taps, card.source});
    }
    return results;
}

ViewStudy study_view(const Scene& scene, const View& view, const Plan& plan,
                     const ProgressSink& progress_sink) {
    const MeasuredView measured_view{scene, view, plan, progress_sink};
    progress_sink.is_shown("truth", measured_view.truth());
    if (progress_sink.is_known) progress_sink.is_known(measured_view.evidence());
    ViewStudy study{.scene = scene.name,
                    .view = view.name,
                    .reason = {},
                    .width = view.width,
                    .height = view.height,
                    .first_row = plan.first_row,
                    .textures = measured_view.texture_sizes(),
                    .methods = {},
                    .truth_file = {},
                    .truth_seconds = measured_view.truth_seconds()};
    for (const StudyMethod& method : plan.methods) {
        if (progress_sink.wants_to_stop()) break;
        progress_sink.begins(method.label, 1);
        try {
            study.methods.push_back(measured_view.score(method, progress_sink));
        } catch (const RendererFailure& e) {
            study.missing.push_back({method.label, e.what()});
        }
    }
    return study;
}

View shifted(const View& view, double dx_px, double dy_px) {
    View moved = view;
    const Window& w = view.camera.window;
    const double right = dx_px * (w.right - w.left) / view.width,
                 down = dy_px * (w.top - w.bottom) / view.height;
    moved.camera.window = {w.left + right, w.right + right, w.bottom - down, w.top - down};
    return moved;
}

}  // namespace zproof::study
