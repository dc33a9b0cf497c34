#include "compare/judge.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_sort.h>

#include <stdexcept>
#include <utility>

#include "compare/adjudicate/pixel_check.h"
#include "compare/agree/agree.h"
#include "compare/agree/row_counts.h"

namespace zproof {

namespace {

/// What one thread counts and lists.
struct Tally {
    ClassCounts counts{};
    BoundRecord candidate_depth, reference_depth, candidate_edges, reference_edges;
    std::uint64_t reference_defects = 0, adjudicated = 0, exact = 0;
    std::vector<Finding> findings;

    void count(const PixelCheck& pixel, PixelClass verdict) {
        ++counts[std::size_t(verdict)];
        reference_defects += is_reference_wrong(pixel);
        if (pixel.ids_differ())
            count_decisions(pixel.candidate_decision, pixel.reference_decision);
        else
            count_depths(pixel);
    }

  private:
    void count_decisions(const QueryResult& candidate, const QueryResult& reference) {
        ++adjudicated;
        exact += candidate.decision.exact || reference.decision.exact;
        if (const auto& d = candidate.displacement_over_eps) zproof::count(candidate_edges, *d);
        if (const auto& d = reference.displacement_over_eps) zproof::count(reference_edges, *d);
    }
    /// Counts the depths of pixels that name the same triangle.
    void count_depths(const PixelCheck& pixel) {
        const bool is_background = pixel.candidate.answer.primitive == PrimitiveId::none;
        if (is_background || pixel.candidate.is_invalid || pixel.reference.is_invalid) return;
        zproof::count(candidate_depth, pixel.candidate.error_over_bound);
        zproof::count(reference_depth, pixel.reference.error_over_bound);
    }
};

/// Integers and maxima: the order of adding does not matter.
void add(Verdict& sum, const Tally& part) {
    for (std::size_t c = 0; c < part.counts.size(); ++c) sum.counts[c] += part.counts[c];
    add(sum.candidate_depth, part.candidate_depth);
    add(sum.reference_depth, part.reference_depth);
    add(sum.candidate_edges, part.candidate_edges);
    add(sum.reference_edges, part.reference_edges);
    sum.reference_defects += part.reference_defects;
    sum.adjudicated += part.adjudicated;
    sum.exact += part.exact;
    sum.findings.insert(sum.findings.end(), part.findings.begin(), part.findings.end());
}

bool is_wanted(PixelClass verdict, const JudgeOptions& options) {
    return options.findings == JudgeOptions::Findings::differences ? verdict != PixelClass::agree
                                                                   : !passes(verdict);
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
    const Agreement agreement = find_agreement(frames, verdict.errors ? &*verdict.errors : nullptr);
    verdict.candidate_depth = agreement.candidate_depth;
    verdict.reference_depth = agreement.reference_depth;
    verdict.counts[std::size_t(PixelClass::agree)] = size.pixel_count() - agreement.undecided.size();
    tbb::enumerable_thread_specific<Tally> tallies;
    check_pixels(frames, agreement.undecided, [&](std::size_t i, const PixelCheck& pixel) {
        const PixelCoord& place = agreement.undecided[i].place;
        const PixelClass said = class_of(pixel);
        verdict.classes.at(place.x, place.y) = said;
        tallies.local().count(pixel, said);
        if (is_wanted(said, options)) tallies.local().findings.push_back(finding_of(frames, pixel, place));
    });
    for (const Tally& tally : tallies) add(verdict, tally);
    tbb::parallel_sort(verdict.findings, [](const Finding& a, const Finding& b) {
        return std::pair{a.y, a.x} < std::pair{b.y, b.x};
    });
    return verdict;
}

}  // namespace zproof
