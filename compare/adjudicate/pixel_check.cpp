#include "compare/adjudicate/pixel_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/adjudicate/tile_work.h"
#include "compare/admissible/depth_rule.h"
#include "compare/attributes/attribute_check.h"

namespace zproof {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr DepthCheck nothing_to_check{
    .bound = {nan, nan, nan}, .error_over_bound = nan, .is_admissible = true};

/// The answer must be valid.
DepthCheck check_depth_of(const FramePair& frames, const BoundedFrame& frame, const Answer& answer,
                          const PixelCoord& place) {
    if (answer.primitive == PrimitiveId::none) return nothing_to_check;
    const CornersWorld p_world = corners_of(frames.scene, std::uint32_t(answer.primitive));
    const ViewBounds& bounds = frame.shown_bounds;
    const TriangleDepth depth(TriangleInView(frames.view, bounds, p_world), bounds);
    return check_depth(frames.view, bounds, p_world, depth, place, answer.camera_depth);
}

Answer answer_at(const Frame& frame, const PixelCoord& place) {
    return {frame.primitive.at(place.x, place.y), frame.camera_depth.at(place.x, place.y)};
}

AnswerCheck check_answer(const FramePair& frames, const BoundedFrame& frame, const PixelCoord& place) {
    const Answer answer = answer_at(frame.frame, place);
    if (is_invalid(answer, frames.scene.triangles.size())) return {.answer = answer, .is_invalid = true};
    const DepthCheck depth = check_depth_of(frames, frame, answer, place);
    // a renderer that draws nothing behind the eye gives no depth there, whatever the view shows
    const bool is_no_depth = answer.camera_depth < 0 && frame.bounds.near_depth() >= 0 &&
                             (!depth.is_admissible || frames.view.camera.near_depth < 0);
    const bool is_open = depth.bound.is_open() && !frame.shown_bounds.keeps_to_corners();
    return {answer, is_no_depth, depth.is_admissible, depth.error_over_bound, is_open};
}

/// Checks both answers but does not put them to the admissible set.
PixelCheck answers_at(const FramePair& frames, const UndecidedPixel& pixel) {
    const auto check = [&](const BoundedFrame& frame) {
        return pixel.are_depths_admissible ? AnswerCheck{.answer = answer_at(frame.frame, pixel.place)}
                                           : check_answer(frames, frame, pixel.place);
    };
    return {check(frames.candidate), check(frames.reference)};
}

/// What is decided of an answer may bound its depth.
void hold(AnswerCheck& check, const QueryResult& decided) {
    check.is_depth_admissible &= !(check.answer.camera_depth > decided.farthest_depth);
}

}  // namespace

bool is_invalid(const Answer& answer, std::size_t triangle_count) {
    if (std::isnan(answer.camera_depth)) return true;
    if (answer.primitive == PrimitiveId::none) return answer.camera_depth != background_depth;
    return std::size_t(answer.primitive) >= triangle_count;
}

void check_pixels(const FramePair& frames, std::span<const UndecidedPixel> pixels,
                  const std::function<void(std::size_t, const PixelCheck&)>& tell) {
    std::vector<PixelCoord> places;
    for (const UndecidedPixel& pixel : pixels) places.push_back(pixel.place);
    const BoundedFrame& candidate = frames.candidate;
    const AttributeCheck attributes(frames.scene, frames.view, candidate.frame, candidate.precision);
    const auto check_pixel = [&](TileWork& work, std::size_t i, double searched_px) {
        const PixelCoord& place = pixels[i].place;
        PixelCheck pixel = answers_at(frames, pixels[i]);
        if (pixels[i].is_id_undecided) {
            // decides an answer, if it is one; the reach that this needs, or 0
            const auto decide = [&](const BoundedFrame& frame, const AnswerCheck& check, QueryResult& said) {
                const AskedReason reason = pixel.ids_differ() ? AskedReason::the_first : AskedReason::any;
                const PixelQuery query{&frame.bounds, check.answer.primitive,   place.x, place.y,
                                       reason,        check.answer.camera_depth};
                return check.is_invalid ? 0 : work.decide(query, searched_px, said);
            };
            double needed_px = decide(candidate, pixel.candidate, pixel.candidate_decision);
            if (pixel.ids_differ())
                needed_px =
                    std::max(needed_px, decide(frames.reference, pixel.reference, pixel.reference_decision));
            if (needed_px > 0) return needed_px;
            hold(pixel.candidate, pixel.candidate_decision);
            hold(pixel.reference, pixel.reference_decision);
        }
        pixel.wrong_attribute = attributes.at(place).wrong;
        tell(i, pixel);
        return 0.0;
    };
    Adjudicator(frames.scene, frames.view, {&frames.candidate.bounds, &frames.reference.bounds},
                QueryDetail::displacement)
        .for_each_pixel(places, check_pixel);
}

PixelClass class_of(const PixelCheck& pixel) {
    const Admissibility candidate = pixel.candidate_decision.decision.admissibility,
                        reference = pixel.reference_decision.decision.admissibility;
    if (pixel.candidate.is_invalid) return PixelClass::invalid;
    if (!is_admissible(candidate)) return class_of(candidate, reference);
    if (!pixel.candidate.is_depth_admissible) return PixelClass::wrong_depth;
    if (pixel.wrong_attribute) return PixelClass::wrong_attribute;
    if (is_reference_wrong(pixel)) return PixelClass::reference_wrong;
    return pixel.ids_differ() ? class_of(candidate, reference) : PixelClass::agree;
}

bool is_reference_wrong(const PixelCheck& pixel) {
    return pixel.reference.is_invalid || !pixel.reference.is_depth_admissible ||
           is_inadmissible(pixel.reference_decision.decision.admissibility);
}

Finding finding_of(const FramePair& frames, const PixelCheck& pixel, const PixelCoord& place) {
    const Answer& candidate = pixel.candidate.answer;
    DepthCheck depth = pixel.candidate.is_invalid
                           ? nothing_to_check
                           : check_depth_of(frames, frames.candidate, candidate, place);
    if (depth.bound.high > pixel.candidate_decision.farthest_depth) {
        depth.bound.high = pixel.candidate_decision.farthest_depth;
        const auto [low, truth, high] = depth.bound;
        // nobody may show the true depth where that is hidden: an error counts from the middle
        depth.error_over_bound =
            error_over_bound({low, truth > high ? (low + high) / 2 : truth, high}, candidate.camera_depth);
    }
    return {.x = place.x,
            .y = place.y,
            .verdict = class_of(pixel),
            .candidate = candidate,
            .reference = pixel.reference.answer,
            .eps_px = pixel.candidate_decision.decision.eps_px,
            .candidate_depth = depth.bound,
            .error_over_bound = depth.error_over_bound,
            .wrong_attribute =
                class_of(pixel) == PixelClass::wrong_attribute ? pixel.wrong_attribute : std::nullopt};
}

}  // namespace zproof
