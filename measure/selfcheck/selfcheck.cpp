#include "measure/selfcheck/selfcheck.h"

#include <algorithm>

#include "compare/explanation/explain.h"
#include "compare/judge.h"

namespace zproof::measure {
namespace {

void add(const Scene& scene, const Verdict& verdict, Variant::Numbers numbers, VariantResult& result) {
    for (std::size_t c = 0; c < result.counts.size(); ++c) result.counts[c] += verdict.counts[c];
    result.defects += defect_count(verdict);
    const bool may_blame_original = numbers == Variant::Numbers::same;
    if (may_blame_original) result.original_defects += verdict.reference_defects;
    const auto is_defect = [&](const Finding& finding) {
        return !passes(finding.verdict) ||
               (may_blame_original && finding.verdict == PixelClass::reference_wrong);
    };
    const auto first = std::ranges::find_if(verdict.findings, is_defect);
    if (!result.first_defect.empty() || first == verdict.findings.end()) return;
    result.first_defect = "pixel " + std::to_string(first->x) + ", " + std::to_string(first->y) + ": " +
                          in_words(scene, *first);
}

}  // namespace

VariantResult check_variant(const Renderer& renderer, const Scene& scene, const View& view,
                            const Frame& original, const Variant& variant) {
    VariantResult result;
    result.variant = variant.name;
    const std::vector<VariantPicture> pictures = variant.pictures(scene, view);
    result.was_drawn = !pictures.empty();
    if (pictures.empty()) return result;
    const Scene told = variant.scene(scene);
    for (const VariantPicture& picture : pictures) {
        const Frame frame = picture.judged(renderer.render(told, picture.view));
        const Verdict verdict = judge(told, picture.judged_view, {frame, renderer.declared},
                                      {picture.expected(original), renderer.declared},
                                      {.findings = JudgeOptions::Findings::differences});
        add(told, verdict, variant.numbers, result);
    }
    return result;
}

}  // namespace zproof::measure
