#include "tests/attack/tightness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "compare/labels/labelled_frame.h"
#include "frame/precision_text.h"
#include "tests/attack/planted_values.h"

namespace zproof::attack {

namespace {

constexpr std::array factors{1.01, 1.1, 2.0};

/// Of all displacements that wrong answers need, the one that stands at this share of their order.
double need_at(const std::vector<double>& needs, double share) {
    return needs[std::size_t(share * double(needs.size() - 1))];
}

std::vector<std::uint32_t> label_of_triangles(const Scene& scene) {
    constexpr std::uint32_t labels = 3;
    std::vector<std::uint32_t> label_of;
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) label_of.push_back(t / 2 % labels);
    return label_of;
}

}  // namespace

/// A frame of wrong pixels, and what was said.
struct Tightness::Judged {
    const Trial& trial;
    const PlantedFrame& planted;
    Verdict verdict;
    std::string wrong;  ///< empty: what each pixel's own kind is called
    std::string promise;
};

void Tightness::count(const Judged& j) {
    const bool is_beside = j.trial.scene().view.sample.offset_px != glm::dvec2(0);
    for (const PlantedPixel& p : j.planted.pixels) {
        const std::string wrong = j.wrong.empty() ? std::string(name_of(p.kind)) : j.wrong;
        Tally& tally = rows_[{wrong + (is_beside ? ", sample" : ""), j.promise}];
        ++tally.planted;
        const PixelClass said = j.verdict.classes.at(p.x, p.y);
        if (said == PixelClass::undecidable) ++tally.undecidable;
        if (!passes(said)) continue;
        ++tally.passed;
        if (p.factor < tally.farthest) continue;
        tally.farthest = p.factor;
        std::ostringstream where;
        where << j.trial.scene().name << " (" << p.x << ", " << p.y << "): triangle "
              << int(j.planted.frame.primitive.at(p.x, p.y)) << " depth "
              << j.planted.frame.camera_depth.at(p.x, p.y) << " is called " << name_of(said);
        tally.where = where.str();
    }
}

std::uint64_t Tightness::planted() const {
    std::uint64_t all = 0;
    for (const auto& [row, tally] : rows_) all += tally.planted;
    return all;
}

void Tightness::plant_in(const AttackScene& scene) {
    const Trial trial(scene);
    plant_places(trial);
    plant_snapped(trial);
    plant_labels(trial);
    plant_values(trial);
}

/// The promise is made to fit: what a wrong answer needs, divided by the factor.
void Tightness::plant_places(const Trial& trial) {
    constexpr double share = 1e-6;
    for (const Sharing sharing : {Sharing::alike, Sharing::apart}) {
        const WrongPlaces wrong(trial, share, sharing);
        const std::vector<double> needs = wrong.needs();
        if (needs.empty()) continue;
        for (const double factor : factors)
            for (const double at : {0.1, 0.25, 0.5}) {
                const double eps_px = need_at(needs, at) / factor;
                if (eps_px < 0x1p-18) continue;
                const BoundedPrecision promise{
                    .eps_px = eps_px, .depth_relative = share, .watertight = sharing == Sharing::alike};
                const PlantedFrame planted = wrong.planted(eps_px, factor);
                count({trial, planted, trial.judge_of(planted.frame, promise), "",
                       promise.watertight ? "bounded" : "bounded, watertight=false"});
            }
    }
}

void Tightness::plant_snapped(const Trial& trial) {
    const std::string exact = "raster,transform=float64,interpolation=float64";
    const WrongPlaces wrong(trial, 1e-6, Sharing::alike);
    for (const char* keys : {",subpixel_bits=3", ",subpixel_bits=6", ",subpixel_bits=4,snap=truncate"}) {
        const auto promise = std::get<RasterPrecision>(precision_from_word(exact + keys));
        const double step_px = std::ldexp(1.0, -promise.subpixel_bits);
        for (const double factor : factors) {
            const PlantedFrame planted =
                wrong.planted(promise.snap == Snap::nearest ? step_px / 2 : step_px, factor);
            count({trial, planted, trial.judge_of(planted.frame, promise), "",
                   promise.snap == Snap::nearest ? "raster" : "raster, snap=truncate"});
        }
    }
}

void Tightness::plant_labels(const Trial& trial) {
    constexpr double share = 1e-6;
    const AttackScene& s = trial.scene();
    const TriangleLabels labels{.ids = "attack", .of_triangle = label_of_triangles(s.scene)};
    const TriangleLabels absent{.ids = "none",
                                .of_triangle = std::vector<std::uint32_t>(s.scene.triangles.size(), 0),
                                .are_absent = true};
    const auto judged = [&](const Frame& frame, const Precision& promise, const TriangleLabels& by) {
        const Frame said = with_labels(frame, by);
        return trial.judge_of(with_triangles(s.scene, s.view, {said, promise}, by, trial.reference()),
                              promise);
    };
    const WrongPlaces wrong(trial, share, Sharing::alike);
    const std::vector<double> needs = wrong.needs();
    for (const double factor : factors) {
        if (!needs.empty()) {
            const double eps_px = std::max(need_at(needs, 0.25) / factor, 0x1p-18);
            const BoundedPrecision promise{.eps_px = eps_px, .depth_relative = share};
            const PlantedFrame planted = wrong.planted_labels(labels.of_triangle, eps_px, factor);
            count({trial, planted, judged(planted.frame, promise, labels), "label", "bounded"});
        }
        const BoundedPrecision promise{.eps_px = 0.01, .depth_relative = 1e-4};
        const PlantedFrame planted = with_depths_before_all(trial, promise, factor);
        count({trial, planted, judged(planted.frame, promise, absent), "depth alone", "bounded"});
    }
}

void Tightness::plant_values(const Trial& trial) {
    for (const double factor : factors) {
        for (const BoundedPrecision& promise : {BoundedPrecision{.eps_px = 1e-5, .depth_relative = 1e-5},
                                                BoundedPrecision{.eps_px = 0.01, .depth_relative = 1e-4},
                                                BoundedPrecision{.eps_px = 1e-5, .depth_absolute = 0.01},
                                                BoundedPrecision{.eps_px = 0.1, .depth_relative = 0.5}})
            for (const DepthFrom from : {DepthFrom::square, DepthFrom::own_part}) {
                const PlantedFrame planted = with_wrong_depths(trial, promise, from, factor);
                count({trial, planted, trial.judge_of(planted.frame, promise), "",
                       from == DepthFrom::square ? "bounded" : "bounded, own part"});
            }
        for (const BoundedPrecision& promise : {BoundedPrecision{.eps_px = 0.01, .depth_relative = 1e-6},
                                                BoundedPrecision{.eps_px = 0.2, .depth_relative = 1e-4}}) {
            const PlantedFrame planted = with_wrong_weights(trial, promise, factor);
            count({trial, planted, trial.judge_of(planted.frame, promise), "", "bounded"});
        }
    }
}

}  // namespace zproof::attack
