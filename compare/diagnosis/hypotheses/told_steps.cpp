#include "compare/diagnosis/hypotheses/told_steps.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "math/rounding.h"
#include "scenes/camera_depth.h"

namespace zproof {

namespace {

constexpr std::size_t most_looked_at = 1'000;
constexpr std::size_t least_levels = 17;

/// Some of the candidate's depths.
std::set<double> some_told(const Frame& frame) {
    std::set<double> told;
    const std::size_t count = frame.primitive.pixels().size();
    for (std::size_t i = 0; i < count; i += count / most_looked_at + 1)
        if (const double depth = double(frame.camera_depth.pixels()[i]);
            frame.primitive.pixels()[i] != PrimitiveId::none && std::isfinite(depth))
            told.insert(depth);
    return told;
}

/// float32's roundings of a number of steps.
bool is_whole(double steps) {
    const double error = gamma(4, unit_roundoff_float32) * std::abs(steps);
    return error < 0.25 && std::abs(steps - std::round(steps)) <= error;
}

}  // namespace

double told_step(const DiagnosisInput& input) {
    if (!CameraDepth(input.convention, input.view).is_identity()) return 0;
    const std::set<double> told = some_told(input.candidate.frame);
    if (told.size() < least_levels) return 0;
    std::vector<double> steps{1, 0.1, 0.01, 0.001, 0.0001, 1.0 / 16, 1.0 / 256};
    for (const double full : {1.0, input.view.camera.far_depth})
        for (const double levels : {255, 65535})
            if (std::isfinite(full)) steps.push_back(full / levels);
    std::ranges::sort(steps, std::greater());
    const auto found = std::ranges::find_if(steps, [&](double step) {
        return std::ranges::all_of(told, [&](double depth) { return is_whole(depth / step); });
    });
    return found == steps.end() ? 0 : *found;
}

void allow_steps(Hypothesis& hypothesis, double step) {
    if (step == 0) return;
    hypothesis.report = [step, exact = hypothesis.report](const DepthBound& bound, const Claim& claim) {
        const auto [low, high] = exact(bound, claim);
        return ReportedDepth{low - step, high + step};
    };
    if (!hypothesis.tellable)
        hypothesis.tellable = [step](const ReportedDepth& range) {
            return (range.high - range.low) / step + 1;
        };
}

}  // namespace zproof
