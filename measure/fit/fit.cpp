#include "measure/fit/fit.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "compare/adjudicate/pixel_check.h"
#include "measure/fit/verification.h"

namespace zproof::measure {
namespace {

using Answers = std::vector<PixelAnswer>;

/// The answers of a frame, and where it gives none.
struct FrameAnswers {
    Answers given, none;
};

FrameAnswers answers_of(const Scene& scene, const View& view, const Frame& frame) {
    FrameAnswers answers;
    for (int y = 0; y < frame.size().height; ++y)
        for (int x = 0; x < frame.size().width; ++x) {
            const PixelAnswer a{{x, y}, {frame.primitive.at(x, y), frame.camera_depth.at(x, y)}};
            const bool is_behind_the_eye = a.answer.camera_depth < 0 && view.camera.near_depth >= 0,
                       is_none = is_behind_the_eye || is_invalid(a.answer, scene.triangles.size());
            (is_none ? answers.none : answers.given).push_back(a);
        }
    return answers;
}

/// Answers by what the gap rule says of their errors.
struct Split {
    Answers kept, alone, beyond;
    std::vector<int> kept_octaves, alone_octaves;
};

Split split(const Answers& answers, const std::vector<int>& octaves, std::optional<int> last) {
    Split parts;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (octaves[i] == no_octave) {
            parts.beyond.push_back(answers[i]);
        } else if (last && octaves[i] > *last) {
            parts.alone.push_back(answers[i]);
            parts.alone_octaves.push_back(octaves[i]);
        } else {
            parts.kept.push_back(answers[i]);
            parts.kept_octaves.push_back(octaves[i]);
        }
    }
    return parts;
}

OctaveCounts count(const std::vector<int>& octaves, std::size_t right) {
    OctaveCounts counts;
    counts.add(least_octave, right);
    for (const int octave : octaves) counts.add(octave);
    return counts;
}

/// What the answers need of eps, under one allowance.
struct PlaceFit {
    OctaveCounts counts;
    Split parts;
    LeastEps eps, eps_of_alone;  ///< of what is kept, and of what stands alone
};

/// Depths, their errors, and what is kept of them.
struct DepthFit {
    OctaveCounts counts;
    LeastDepth kept, alone;
    Answers left_alone, beyond;
};

LeastDepth greater(const LeastDepth& a, const LeastDepth& b) {
    return a.error.relative < b.error.relative ? b : a;
}

class Fitter {
  public:
    Fitter(const Scene& scene, const View& view, const Frame& frame)
        : scene_(scene), view_(view), frame_(frame), rule_(scene, view) {}

    ViewFit operator()();

  private:
    PlaceFit fit_place(const Answers& displaced, const Allowance& allowance) const;
    DepthFit fit_depth(const Answers& answers, double eps_px) const;
    /// Opens the mesh at pixels that it explains ten times as well; how many.
    std::uint64_t open(Mesh mesh, const Allowance& allowance);
    /// Sets right_ and displaced_.
    void sort_out(const Answers& answers);
    void tell(const PlaceFit& place, const DepthFit& depth);
    void leave_out(const Answers& answers, LeftOut::Reason reason);

    const Scene& scene_;
    const View& view_;
    const Frame& frame_;
    PlaceRule rule_;
    Answers right_, displaced_;  ///< right at the pixel's centre, or not
    ViewFit fit_;
};

PlaceFit Fitter::fit_place(const Answers& displaced, const Allowance& allowance) const {
    const std::vector<int> octaves = rule_.octaves(displaced, allowance);
    PlaceFit fit{.counts = count(octaves, right_.size()), .parts = {}, .eps = {}, .eps_of_alone = {}};
    fit.parts = split(displaced, octaves, fit.counts.last_before_gap());
    fit.eps = rule_.least(fit.parts.kept, fit.parts.kept_octaves, allowance);
    fit.eps_of_alone = rule_.least(fit.parts.alone, fit.parts.alone_octaves, allowance);
    return fit;
}

DepthFit Fitter::fit_depth(const Answers& answers, double eps_px) const {
    const std::vector<DepthError> errors = depth_errors(scene_, view_, answers, eps_px);
    std::vector<int> octaves(errors.size());
    std::ranges::transform(errors, octaves.begin(),
                           [](const DepthError& e) { return octave_of(e.relative); });
    DepthFit fit{.counts = count(octaves, 0), .kept = {}, .alone = {}, .left_alone = {}, .beyond = {}};
    const std::optional<int> last = fit.counts.last_before_gap();
    const Split parts = split(answers, octaves, last);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (octaves[i] == no_octave) continue;
        LeastDepth& part = last && octaves[i] > *last ? fit.alone : fit.kept;
        part = greater(part, {errors[i], answers[i].pixel});
    }
    fit.left_alone = parts.alone;
    fit.beyond = parts.beyond;
    return fit;
}

std::uint64_t Fitter::open(Mesh mesh, const Allowance& allowance) {
    Answers opened = displaced_;
    for (PixelAnswer& a : opened) a.mesh = mesh;
    const PlaceFit fit = fit_place(opened, allowance);
    const std::vector<bool> needs_none = rule_.admit(displaced_, factor_apart * fit.eps.px.high, allowance),
                            suffices = rule_.admit(opened, fit.eps.px.high, allowance);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < displaced_.size(); ++i) {
        if (needs_none[i] || !suffices[i]) continue;
        displaced_[i].mesh = mesh;
        ++count;
    }
    return count;
}

void Fitter::leave_out(const Answers& answers, LeftOut::Reason reason) {
    for (const PixelAnswer& a : answers) fit_.left_out.push_back({a.pixel, a.answer, reason});
}

ViewFit Fitter::operator()() {
    const FrameAnswers answers = answers_of(scene_, view_, frame_);
    fit_.pixels = answers.given.size() + answers.none.size();
    sort_out(answers.given);
    // 1: by place alone; 2: the depth error beside that; 3: eps beside that depth error
    const double eps_of_place = fit_place(displaced_, {.depths = Allowance::Depths::any}).eps.px.high;
    const LeastDepth beside_place = fit_depth(right_, eps_of_place).kept;
    const Allowance allowed{.depth_relative = promised_relative(beside_place.error.relative)};
    fit_.seams = open(Mesh::with_seams, allowed);
    fit_.gaps = open(Mesh::with_gaps, allowed);
    fit_.promise.watertight = fit_.gaps == 0;
    const PlaceFit place = fit_place(displaced_, allowed);
    fit_.promise.eps_px = rounded_up(place.eps.px.high);
    // 4: the depth error beside that eps, if ids need no more of it
    Answers kept = right_;
    kept.insert(kept.end(), place.parts.kept.begin(), place.parts.kept.end());
    const DepthFit depth = fit_depth(kept, fit_.promise.eps_px);
    const double least = promised_relative(depth.kept.error.relative);
    const bool suffices =
        rule_.inadmissible(place.parts.kept, fit_.promise.eps_px, {.depth_relative = least}).empty();
    fit_.depth = suffices ? depth.kept : greater(depth.kept, beside_place);
    fit_.promise.depth_relative = promised_relative(fit_.depth.error.relative);
    for (const int factor : {2, 4, 8}) {
        const double eps_px = factor * fit_.promise.eps_px;
        fit_.trade.push_back({eps_px, fit_depth(kept, eps_px).kept.error});
    }
    tell(place, depth);
    leave_out(answers.none, LeftOut::Reason::no_answer);
    return std::move(fit_);
}

void Fitter::sort_out(const Answers& answers) {
    const std::vector<bool> is_right = rule_.admit(answers, least_eps_px, {});
    for (std::size_t i = 0; i < answers.size(); ++i)
        (is_right[i] ? right_ : displaced_).push_back(answers[i]);
}

void Fitter::tell(const PlaceFit& place, const DepthFit& depth) {
    fit_.eps_px = place.counts;
    fit_.eps = place.eps;
    fit_.depth_relative = depth.counts;
    fit_.depth_of_alone = depth.alone;
    fit_.eps_of_alone = place.eps_of_alone;
    leave_out(place.parts.alone, LeftOut::Reason::alone_by_place);
    leave_out(depth.left_alone, LeftOut::Reason::alone_by_depth);
    leave_out(place.parts.beyond, LeftOut::Reason::beyond_all_places);
    leave_out(depth.beyond, LeftOut::Reason::beyond_all_depths);
}

bool are_left_out(const std::vector<PixelCoord>& pixels, const std::vector<LeftOut>& left_out) {
    std::set<std::pair<int, int>> places;
    for (const LeftOut& l : left_out) places.emplace(l.pixel.x, l.pixel.y);
    return std::ranges::all_of(pixels, [&](const PixelCoord& p) { return places.contains({p.x, p.y}); });
}

}  // namespace

ViewFit fit(const Scene& scene, const View& view, const Frame& frame) {
    if (frame.size() != Resolution{view.width, view.height})
        throw std::invalid_argument("fit: the frame must have the view's size");
    ViewFit fit = Fitter(scene, view, frame)();
    const std::vector<PixelCoord> defects = defects_under(fit.promise, scene, view, frame);
    fit.defects = defects.size();
    fit.is_verified = are_left_out(defects, fit.left_out);
    return fit;
}

BoundedPrecision cover(const BoundedPrecision& a, const BoundedPrecision& b) {
    return {.eps_px = std::max(a.eps_px, b.eps_px),
            .depth_relative = std::max(a.depth_relative, b.depth_relative),
            .depth_absolute = std::max(a.depth_absolute, b.depth_absolute),
            .depth_of_range = std::max(a.depth_of_range, b.depth_of_range),
            .watertight = a.watertight && b.watertight};
}

}  // namespace zproof::measure
