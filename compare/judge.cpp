#include "compare/judge.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <stdexcept>
#include <utility>

#include "compare/adjudicate/pixel_check.h"
#include "compare/adjudicate/unproven_pixels.h"
#include "compare/agree/agree.h"
#include "compare/attributes/attribute_check.h"

namespace zproof {

namespace {

/// Counts what the first tier did not.
void count(Verdict& verdict, const PixelCheck& pixel, const UndecidedPixel& undecided) {
    verdict.reference_defects += is_reference_wrong(pixel);
    verdict.open_depths += pixel.candidate.is_depth_open;
    const QueryResult &candidate = pixel.candidate_decision, &reference = pixel.reference_decision;
    if (pixel.ids_differ() || candidate.decision.eps_px > 0) {
        ++verdict.adjudicated;
        verdict.exact += candidate.decision.exact || reference.decision.exact;
        if (const auto& d = candidate.displacement_over_eps) count(verdict.candidate_edges, *d);
        if (const auto& d = reference.displacement_over_eps) count(verdict.reference_edges, *d);
    }
    const bool is_background = pixel.candidate.answer.primitive == PrimitiveId::none;
    if (pixel.ids_differ() || undecided.are_depths_admissible || is_background ||
        pixel.candidate.is_invalid || pixel.reference.is_invalid)
        return;
    count(verdict.candidate_depth, pixel.candidate.error_over_bound);
    count(verdict.reference_depth, pixel.reference.error_over_bound);
}

/// Integers and maxima: the order of adding does not matter.
void add(Verdict& sum, const Verdict& part) {
    for (std::size_t c = 0; c < part.counts.size(); ++c) sum.counts[c] += part.counts[c];
    add(sum.candidate_depth, part.candidate_depth);
    add(sum.reference_depth, part.reference_depth);
    add(sum.candidate_edges, part.candidate_edges);
    add(sum.reference_edges, part.reference_edges);
    sum.reference_defects += part.reference_defects;
    sum.adjudicated += part.adjudicated;
    sum.exact += part.exact;
    sum.open_depths += part.open_depths;
    sum.findings.insert(sum.findings.end(), part.findings.begin(), part.findings.end());
}

bool is_wanted(PixelClass verdict, const JudgeOptions& options) {
    return options.findings == JudgeOptions::Findings::differences ? verdict != PixelClass::agree
                                                                   : !passes(verdict);
}

/// Pixels that agree but for an attribute of the candidate. Counts those whose attributes are open.
std::vector<UndecidedPixel> agreeing_with_wrong_attribute(const FramePair& frames, Verdict& verdict) {
    const BoundedFrame& candidate = frames.candidate;
    if (!candidate.frame.attributes.are_given()) return {};
    const AttributeCheck check(frames.scene, frames.view, candidate.frame, candidate.precision);
    struct Found {
        std::vector<UndecidedPixel> wrong;
        std::uint64_t open = 0;
    };
    tbb::enumerable_thread_specific<Found> found;
    tbb::parallel_for(0, frames.view.height, [&](int y) {
        Found& here = found.local();
        for (int x = 0; x < frames.view.width; ++x) {
            if (verdict.classes.at(x, y) != PixelClass::agree) continue;
            const CheckedAttributes said = check.at({x, y});
            here.open += said.is_open;
            if (said.wrong) here.wrong.push_back({.place = {x, y}, .is_id_undecided = false});
        }
    });
    std::vector<UndecidedPixel> all;
    for (const Found& part : found) {
        all.insert(all.end(), part.wrong.begin(), part.wrong.end());
        verdict.open_attributes += part.open;
    }
    return all;
}

}  // namespace

Verdict judge(const Scene& scene, const View& view, const RenderedFrame& candidate,
              const RenderedFrame& reference, const JudgeOptions& options) {
    const Resolution size{view.width, view.height};
    if (candidate.frame.size() != size || reference.frame.size() != size)
        throw std::invalid_argument("judge: both frames must have the view's size");
    Verdict verdict;
    verdict.classes = Plane<PixelClass>(size, PixelClass::agree);
    if (options.errors == JudgeOptions::Errors::maps)
        verdict.errors = ErrorMaps{Plane<float>::unwritten(size), Plane<float>::unwritten(size)};
    const FramePair frames{scene, view, {view, candidate}, {view, reference}};
    const Agreement agreement =
        find_agreement(frames, find_unproven_pixels(frames), verdict.errors ? &*verdict.errors : nullptr);
    verdict.candidate_depth = agreement.candidate_depth;
    verdict.reference_depth = agreement.reference_depth;
    verdict.counts[std::size_t(PixelClass::agree)] = size.pixel_count() - agreement.undecided.size();
    tbb::enumerable_thread_specific<Verdict> tallies;  // what one thread counts and lists
    const auto record = [&](const PixelCheck& pixel, const PixelCoord& place) {
        const PixelClass said = class_of(pixel);
        verdict.classes.at(place.x, place.y) = said;
        ++tallies.local().counts[std::size_t(said)];
        if (is_wanted(said, options)) tallies.local().findings.push_back(finding_of(frames, pixel, place));
    };
    check_pixels(frames, agreement.undecided, [&](std::size_t i, const PixelCheck& pixel) {
        record(pixel, agreement.undecided[i].place);
        count(tallies.local(), pixel, agreement.undecided[i]);
    });
    const std::vector<UndecidedPixel> wrong = agreeing_with_wrong_attribute(frames, verdict);
    check_pixels(frames, wrong,
                 [&](std::size_t i, const PixelCheck& pixel) { record(pixel, wrong[i].place); });
    verdict.counts[std::size_t(PixelClass::agree)] -= wrong.size();
    for (const Verdict& tally : tallies) add(verdict, tally);
    tbb::parallel_sort(verdict.findings, [](const Finding& a, const Finding& b) {
        return std::pair{a.y, a.x} < std::pair{b.y, b.x};
    });
    return verdict;
}

}  // namespace zproof
