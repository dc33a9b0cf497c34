#include "compare/judge.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

#include "compare/adjudication.h"

namespace zproof {

namespace {

/// Every open pixel of the frame in raster order; depths are counted into the verdict.
std::vector<OpenPixel> first_pass(const Scene& scene, const View& view, const Witness& candidate,
                                  const Witness& reference, Verdict& verdict) {
    constexpr int band_rows = 16;
    std::vector<Findings> bands(static_cast<std::size_t>((view.height + band_rows - 1) / band_rows));
    tbb::parallel_for(0, int(bands.size()), [&](int band) {
        const int top = band * band_rows;
        bands[std::size_t(band)] =
            compare_rows(scene, view, candidate, reference, top, std::min(top + band_rows, view.height));
    });
    Tally sum;
    std::vector<OpenPixel> open;
    std::size_t open_count = 0;
    for (const Findings& band : bands) open_count += band.open.size();
    open.reserve(open_count);
    for (const Findings& band : bands) {
        add(sum, band.tally);
        open.insert(open.end(), band.open.begin(), band.open.end());
    }
    verdict.candidate_depth = sum.candidate;
    verdict.reference_depth = sum.reference;
    return open;
}

bool reference_is_wrong(const OpenPixel& open, const Ruling& ruling) {
    return open.reference_invalid || !open.reference_depth_lawful ||
           !is_lawful(ruling.reference.decision.standing);
}

void record(Verdict& verdict, const OpenPixel& open, const Ruling& ruling) {
    Finding finding = open.finding;
    finding.verdict = class_of(open, ruling);
    finding.eps_px = ruling.candidate.eps_px;
    verdict.reference_defects += reference_is_wrong(open, ruling);
    const bool adjudicated = finding.candidate.primitive != finding.reference.primitive;
    verdict.adjudicated += adjudicated;
    verdict.exact += ruling.candidate.decision.exact || ruling.reference.decision.exact;
    if (const auto& d = ruling.candidate.displacement_over_eps) count(verdict.candidate_edges, *d);
    if (const auto& d = ruling.reference.displacement_over_eps) count(verdict.reference_edges, *d);
    verdict.classes.at(finding.x, finding.y) = finding.verdict;
    if (finding.verdict != PixelClass::agree) verdict.findings.push_back(finding);
}

}  // namespace

Verdict judge(const Scene& scene, const View& view, const Testimony& candidate, const Testimony& reference) {
    const Resolution size{view.width, view.height};
    if (candidate.frame.size() != size || reference.frame.size() != size)
        throw std::invalid_argument("judge: both frames must have the view's size");
    Verdict verdict;
    verdict.classes = Plane<PixelClass>(size, PixelClass::agree);
    const Witness ours(scene, view, candidate), theirs(scene, view, reference);
    const std::vector<OpenPixel> open = first_pass(scene, view, ours, theirs, verdict);
    const std::vector<Ruling> rulings = rule_on(scene, view, ours, theirs, open);
    verdict.findings.reserve(open.size());
    for (std::size_t i = 0; i < open.size(); ++i) record(verdict, open[i], rulings[i]);
    verdict.counts[std::size_t(PixelClass::agree)] = size.pixel_count() - verdict.findings.size();
    for (const Finding& finding : verdict.findings) ++verdict.counts[std::size_t(finding.verdict)];
    return verdict;
}

std::uint64_t defect_count(const Verdict& verdict) {
    std::uint64_t defects = 0;
    for (int c = 0; c < pixel_class_count; ++c)
        if (!passes(PixelClass(c))) defects += verdict.counts[std::size_t(c)];
    return defects;
}

}  // namespace zproof
