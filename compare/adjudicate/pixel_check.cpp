#include "compare/adjudicate/pixel_check.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace zproof {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr DepthCheck nothing_to_check{.bound = {nan, nan, nan}, .error_over_bound = nan, .is_admissible = true};

/// Of an answer that is valid.
DepthCheck check_depth_of(const FramePair& frames, const BoundedFrame& frame, const Answer& answer,
                          const PixelPlace& place) {
    if (answer.primitive == PrimitiveId::none) return nothing_to_check;
    const CornersWorld p_world = corners_of(frames.scene, std::uint32_t(answer.primitive));
    const TriangleDepth depth(TriangleInView(frames.view, frame.bounds, p_world), frame.bounds);
    return check_depth(frames.view, frame.bounds, p_world, depth, place, answer.camera_depth);
}

Answer answer_at(const Frame& frame, const PixelPlace& place) {
    return {frame.primitive.at(place.x, place.y), frame.camera_depth.at(place.x, place.y)};
}

AnswerCheck check_answer(const FramePair& frames, const BoundedFrame& frame, const PixelPlace& place) {
    const Answer answer = answer_at(frame.frame, place);
    if (is_invalid(answer, frames.scene.triangles.size())) return {.answer = answer, .is_invalid = true};
    const DepthCheck depth = check_depth_of(frames, frame, answer, place);
    return {answer, false, depth.is_admissible, depth.error_over_bound};
}

/// Puts the answers of pixels at which ids differ to the admissible set, and hands out what it says.
class Queries {
  public:
    Queries(const FramePair& frames, std::span<const UndecidedPixel> pixels) : frames_(frames), pixels_(pixels) {}

    void decide(std::vector<PixelCheck>& checks) {
        for (std::size_t i = 0; i < checks.size(); ++i) {
            if (!checks[i].ids_differ()) continue;
            add(i, checks[i].candidate, frames_.candidate, checks[i].candidate_decision);
            add(i, checks[i].reference, frames_.reference, checks[i].reference_decision);
        }
        const std::vector<Adjudicated> decided =
            adjudicate(frames_.scene, frames_.view, queries_, Asked::displacement);
        for (std::size_t q = 0; q < decided.size(); ++q) *to_[q] = decided[q];
    }

  private:
    void add(std::size_t pixel, const AnswerCheck& check, const BoundedFrame& frame, Adjudicated& to) {
        if (check.is_invalid) return;
        queries_.push_back({&frame.bounds, check.answer.primitive, pixels_[pixel].x, pixels_[pixel].y});
        to_.push_back(&to);
    }

    const FramePair& frames_;
    std::span<const UndecidedPixel> pixels_;
    std::vector<PixelQuery> queries_;
    std::vector<Adjudicated*> to_;  ///< by query
};

}  // namespace

bool is_invalid(const Answer& answer, std::size_t triangle_count) {
    if (std::isnan(answer.camera_depth) || answer.camera_depth < 0) return true;
    if (answer.primitive == PrimitiveId::none) return answer.camera_depth != background_depth;
    return std::size_t(answer.primitive) >= triangle_count;
}

std::vector<PixelCheck> check_pixels(const FramePair& frames, std::span<const UndecidedPixel> pixels) {
    std::vector<PixelCheck> checks(pixels.size());
    tbb::parallel_for(std::size_t(0), pixels.size(), [&](std::size_t i) {
        const auto& [x, y, differs_in_id_alone] = pixels[i];
        const auto check = [&](const BoundedFrame& frame) {
            return differs_in_id_alone ? AnswerCheck{.answer = answer_at(frame.frame, {x, y})}
                                       : check_answer(frames, frame, {x, y});
        };
        checks[i].candidate = check(frames.candidate);
        checks[i].reference = check(frames.reference);
    });
    Queries(frames, pixels).decide(checks);
    return checks;
}

PixelClass class_of(const PixelCheck& pixel) {
    const Admissibility candidate = pixel.candidate_decision.decision.admissibility,
                        reference = pixel.reference_decision.decision.admissibility;
    if (pixel.candidate.is_invalid) return PixelClass::invalid;
    if (!is_admissible(candidate)) return class_of(candidate, reference);
    if (!pixel.candidate.is_depth_admissible) return PixelClass::wrong_depth;
    if (is_reference_wrong(pixel)) return PixelClass::reference_wrong;
    return pixel.ids_differ() ? class_of(candidate, reference) : PixelClass::agree;
}

bool is_reference_wrong(const PixelCheck& pixel) {
    return pixel.reference.is_invalid || !pixel.reference.is_depth_admissible ||
           !is_admissible(pixel.reference_decision.decision.admissibility);
}

Finding finding_of(const FramePair& frames, const PixelCheck& pixel, const PixelPlace& place) {
    const Answer& candidate = pixel.candidate.answer;
    const DepthCheck depth = pixel.candidate.is_invalid
                                 ? nothing_to_check
                                 : check_depth_of(frames, frames.candidate, candidate, place);
    return {.x = place.x,
            .y = place.y,
            .verdict = class_of(pixel),
            .candidate = candidate,
            .reference = pixel.reference.answer,
            .eps_px = pixel.candidate_decision.decision.eps_px,
            .candidate_depth = depth.bound,
            .error_over_bound = depth.error_over_bound};
}

}  // namespace zproof
