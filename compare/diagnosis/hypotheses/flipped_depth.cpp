#include <utility>

#include "compare/diagnosis/hypotheses/catalogue.h"

namespace zproof {

namespace {

/// One of as many hypotheses as there are, about.
constexpr double bits_of_a_second_name = 8;

/// The hypothesis about an image whose rows are counted from the wrong end.
Hypothesis flipped(Hypothesis h) {
    h.cause.name = "the image is flipped in y, and " + h.cause.name;
    h.learned_bits += bits_of_a_second_name;
    h.cause.description = "Row y holds what belongs to row H - 1 - y. " + h.cause.description;
    h.restate = [lowest = h.view.height - 1, then = std::move(h.restate)](Claim claim) {
        claim.y = lowest - claim.y;
        return then(claim);
    };
    return h;
}

Hypothesis background_told_otherwise(const DiagnosisInput& input) {
    Hypothesis h =
        as_declared(input, {"background has a depth", "Where nothing is seen, the depth is not +infinity.",
                            "Look at the read-back: glReadPixels begins at the lowest row, and the buffer "
                            "holds its clear value."});
    h.restate = [](Claim claim) -> std::optional<Claim> {
        if (claim.answer.primitive == PrimitiveId::none) claim.answer.camera_depth = background_depth;
        return claim;
    };
    return h;
}

}  // namespace

std::vector<Hypothesis> hypotheses_of_flipped_depth(const DiagnosisInput& input) {
    std::vector<Hypothesis> all{flipped(background_told_otherwise(input))};
    for (Hypothesis& h : hypotheses_of_depth(input))
        if (h.report && h.restate && !h.amend) all.push_back(flipped(std::move(h)));
    return all;
}

}  // namespace zproof
