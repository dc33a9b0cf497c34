#include <cmath>

#include "compare/diagnosis/hypotheses/catalogue.h"

namespace zproof {

namespace {

constexpr Resolution single_pixel{1, 1};

bool is_background(const Claim& claim) { return claim.answer.primitive == PrimitiveId::none; }

/// Whatever depth is told will do.
ReportedDepth anything(const DepthBound&, const Claim&) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

/// Triangles' depths that are `wrong` say nothing; their ids are judged.
template <class IsWrong>
Hypothesis no_depth(const DiagnosisInput& input, const Cause& cause, IsWrong is_wrong) {
    Hypothesis h = as_declared(input, cause);
    h.cell = single_pixel;
    h.restate = [is_wrong](Claim claim) -> std::optional<Claim> {
        if (is_background(claim) || !is_wrong(claim.answer.camera_depth)) return std::nullopt;
        claim.answer.camera_depth = 0;
        return claim;
    };
    h.report = anything;
    return h;
}

Hypothesis negated(const DiagnosisInput& input) {
    Hypothesis h = as_declared(input, {"depth has the wrong sign",
                                       "Depth is z in camera space, which is negative ahead, instead of -z.",
                                       "Look at the view matrix: z in camera space is negative ahead."});
    h.restate = [](Claim claim) -> std::optional<Claim> {
        if (!is_background(claim)) claim.answer.camera_depth = -claim.answer.camera_depth;
        return claim;
    };
    return h;
}

Hypothesis background_with_depth(const DiagnosisInput& input) {
    Hypothesis h = as_declared(
        input,
        {"background has a depth", "Where nothing is seen, the id says so and the depth is not +infinity.",
         "Look at the depth buffer's clear value and at how it is turned back: background is +infinity."});
    h.cell = single_pixel;
    h.restate = [](Claim claim) -> std::optional<Claim> {
        if (!is_background(claim) || claim.answer.camera_depth == background_depth) return std::nullopt;
        claim.answer.camera_depth = background_depth;
        return claim;
    };
    return h;
}

Hypothesis background_with_id(const DiagnosisInput& input) {
    Hypothesis h =
        as_declared(input, {"background has an id",
                            "Where nothing is seen, the depth is +infinity and the id is not 0xFFFFFFFF.",
                            "Look at the id buffer's clear value: background is 0xFFFFFFFF."});
    h.cell = single_pixel;
    h.restate = [](Claim claim) -> std::optional<Claim> {
        if (is_background(claim) || claim.answer.camera_depth != background_depth) return std::nullopt;
        claim.answer.primitive = PrimitiveId::none;
        return claim;
    };
    return h;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_signs(const DiagnosisInput& input) {
    return {
        no_depth(
            input,
            {"depth is not a number", "The id is right, the depth is NaN.",
             "Look for 0/0 where depth is interpolated or turned back: w or an area of 0, or 1/depth of 0."},
            [](float depth) { return std::isnan(depth); }),
        no_depth(
            input,
            {"depth is infinite", "The id of a triangle is right, its depth is infinite.",
             "Look at where a hit writes its depth: the clear value stays, or something is divided by 0."},
            [](float depth) { return std::isinf(depth); }),
        background_with_depth(input), background_with_id(input), negated(input)};
}

}  // namespace zproof
