#include "lessons/depth/study.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace zproof::study::depth {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr int gap_distances = 29;
/// Shares of far; twice 20 roundings of float32 are 2.4e-6, and nothing here does better than half of that.
constexpr std::array gaps_wanted{1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 2e-6, 1e-6};

/// A far plane beyond all that is seen, as a camera would be set: an eighth more.
double far_behind(const Seen& seen) { return seen.farthest * 1.125; }

/// The view's planes; an infinite far is brought in, so that every coding means something.
Planes planes_of(const View& view, const Seen& seen) {
    const Camera& camera = view.camera;
    return {camera.near_depth, std::isfinite(camera.far_depth) ? camera.far_depth : far_behind(seen)};
}

void add_ladder(DepthStudy& study, const Scene& scene, const View& view) {
    for (const Format& format : formats()) study.ladder.push_back({format, {}});
    const double far = study.farthest * 1.125;
    for (const double ratio : study.ratios) {
        const Planes planes{far / ratio, far};
        const Seen seen = seen_in(scene, view, planes);
        study.pixels_left.push_back(double(seen.pixels) / double(study.pixels));
        for (LadderRow& row : study.ladder)
            row.p99.push_back(seen.pixels == 0
                                  ? no_number
                                  : error_spread(seen, row.format, Interpolation::reciprocal, planes).p99);
    }
}

/// The deltas from an eighth of the median depth down to 2^-26 of it.
std::vector<double> deltas_for(double median) {
    std::vector<double> deltas;
    for (int k = 3; k <= 26; ++k) deltas.push_back(std::ldexp(median, -k));
    return deltas;
}

void add_fighting(DepthStudy& study, const Seen& seen) {
    study.deltas = deltas_for(study.median);
    for (const Format& format : formats()) {
        FightingCurve curve{format, {}};
        for (const double delta : study.deltas)
            curve.share.push_back(fighting_share(seen, format, study.planes, delta));
        study.fighting.push_back(std::move(curve));
    }
}

/// Measures all curves of a list at once.
void measure(std::vector<GapCurve>& curves) {
    tbb::parallel_for(std::size_t{0}, curves.size(), [&](std::size_t i) {
        curves[i] = gap_curve(curves[i].format, curves[i].interpolation, curves[i].planes, gap_distances);
    });
}

Choice cheapest(double ratio, double gap_of_far) {
    Choice choice{ratio, gap_of_far, {}};
    int bits = 0;
    for (const WorstGap& one : worst_gaps({1, ratio}, gap_of_far * ratio)) {
        if (!one.holds || one.format.range == NdcRange::minus_one_to_one) continue;
        if (bits != 0 && bits_of(one.format.store) != bits) continue;
        bits = bits_of(one.format.store);
        choice.names.push_back(one.format.name);
    }
    return choice;
}

}  // namespace

std::vector<double> ladder_ratios() { return {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}; }

int units_of_depth() { return 4; }
int units_of_gaps() { return 3; }

DepthStudy study_depth(const Scene& scene, const View& view, const Announce& announce) {
    announce("exact depths");
    Planes planes{view.camera.near_depth, view.camera.far_depth};
    const Seen seen = seen_in(scene, view, planes);
    planes = planes_of(view, seen);
    DepthStudy study;
    study.scene = scene.name;
    study.view = view.name;
    study.planes = planes;
    study.size = seen.size;
    study.pixels = seen.pixels;
    study.left_out = seen.left_out;
    study.nearest = seen.nearest;
    study.farthest = seen.farthest;
    study.median = seen.median;
    if (seen.pixels == 0) return study;
    announce("errors");
    for (const Interpolation interpolation : all_interpolations)
        for (const Format& format : formats())
            study.spreads.push_back(error_spread(seen, format, interpolation, planes));
    announce("near and far");
    study.ratios = ladder_ratios();
    add_ladder(study, scene, view);
    announce("fighting layers");
    add_fighting(study, seen);
    return study;
}

GapStudy study_gaps(const Announce& announce) {
    GapStudy study;
    announce("smallest gaps");
    for (const double ratio : ladder_ratios())
        for (const Format& format : formats())
            study.curves.push_back({format, Interpolation::reciprocal, {1, ratio}, {}});
    measure(study.curves);
    announce("interpolations");
    for (const char* name : {"z-float32", "reversed-float32", "z-unorm24"})
        for (const Interpolation way : {Interpolation::reciprocal, Interpolation::ndc})
            study.ways.push_back({format_named(name), way, {1, 1e4}, {}});
    measure(study.ways);
    announce("choices");
    for (const double ratio : ladder_ratios())
        for (const double gap : gaps_wanted) study.choices.push_back(cheapest(ratio, gap));
    return study;
}

std::vector<WorstGap> worst_gaps(const Planes& planes, double wanted) {
    std::vector<WorstGap> gaps;
    for (const Format& format : formats()) {
        const double gap = worst_gap(format, planes);
        gaps.push_back({format, gap, gap <= wanted});
    }
    std::ranges::stable_sort(gaps, {}, [](const WorstGap& g) { return bits_of(g.format.store); });
    return gaps;
}

}  // namespace zproof::study::depth
