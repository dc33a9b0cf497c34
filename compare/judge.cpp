#include "compare/judge.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "compare/adjudicate/pixel_check.h"
#include "compare/agree/agree.h"
#include "compare/agree/row_counts.h"

namespace zproof {

namespace {

void count(const PixelCheck& pixel, PixelClass verdict, Verdict& sum) {
    ++sum.counts[std::size_t(verdict)];
    sum.reference_defects += is_reference_wrong(pixel);
    if (!pixel.ids_differ()) {
        const bool is_held = !pixel.candidate.is_invalid && !pixel.reference.is_invalid &&
                             pixel.candidate.answer.primitive != PrimitiveId::none;
        if (is_held) {
            count(sum.candidate_depth, pixel.candidate.error_over_bound);
            count(sum.reference_depth, pixel.reference.error_over_bound);
        }
        return;
    }
    ++sum.adjudicated;
    sum.exact += pixel.candidate_decision.decision.exact || pixel.reference_decision.decision.exact;
    if (const auto& d = pixel.candidate_decision.displacement_over_eps) count(sum.candidate_edges, *d);
    if (const auto& d = pixel.reference_decision.displacement_over_eps) count(sum.reference_edges, *d);
}

bool is_wanted(PixelClass verdict, const JudgeOptions& options) {
    return options.findings == JudgeOptions::Findings::differences ? verdict != PixelClass::agree : !passes(verdict);
}

}  // namespace

Verdict judge(const Scene& scene, const View& view, const RenderedFrame& candidate, const RenderedFrame& reference,
              const JudgeOptions& options) {
    const Resolution size{view.width, view.height};
    if (candidate.frame.size() != size || reference.frame.size() != size)
        throw std::invalid_argument("judge: both frames must have the view's size");
    Verdict verdict;
    verdict.classes = Plane<PixelClass>(size, PixelClass::agree);
    if (options.errors == JudgeOptions::Errors::maps)
        verdict.errors = ErrorMaps{Plane<float>::unwritten(size), Plane<float>::unwritten(size)};
    const FramePair frames{scene, view, {view, candidate}, {view, reference}};
    const Agreement agreement = find_agreement(frames, verdict.errors ? &*verdict.errors : nullptr);
    verdict.candidate_depth = agreement.candidate_depth;
    verdict.reference_depth = agreement.reference_depth;
    verdict.counts[std::size_t(PixelClass::agree)] = size.pixel_count() - agreement.undecided.size();
    const std::vector<PixelCheck> checks = check_pixels(frames, agreement.undecided);
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const PixelPlace place{agreement.undecided[i].x, agreement.undecided[i].y};
        const PixelClass said = class_of(checks[i]);
        verdict.classes.at(place.x, place.y) = said;
        count(checks[i], said, verdict);
        if (is_wanted(said, options)) verdict.findings.push_back(finding_of(frames, checks[i], place));
    }
    std::ranges::sort(verdict.findings, {}, [](const Finding& f) { return std::pair{f.y, f.x}; });
    return verdict;
}

std::uint64_t defect_count(const Verdict& verdict) {
    std::uint64_t defects = 0;
    for (int c = 0; c < pixel_class_count; ++c)
        if (!passes(PixelClass(c))) defects += verdict.counts[std::size_t(c)];
    return defects;
}

}  // namespace zproof
