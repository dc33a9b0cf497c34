#include "compare/adjudication.h"

namespace zproof {

std::vector<Ruling> rule_on(const Scene& scene, const View& view, const Witness& candidate,
                            const Witness& reference, std::span<const OpenPixel> open) {
    Hearing hearing(scene, view);
    const auto are_heard = [](const OpenPixel& o) {
        return o.finding.candidate.primitive != o.finding.reference.primitive;
    };
    for (const OpenPixel& o : open) {
        if (!are_heard(o)) continue;
        const Finding& f = o.finding;
        if (!o.candidate_invalid) hearing.add(candidate.bounds(), f.candidate.primitive, f.x, f.y);
        if (!o.reference_invalid) hearing.add(reference.bounds(), f.reference.primitive, f.x, f.y);
    }
    const std::vector<Ruled> ruled = hearing.hear(Asked::standing_and_displacement);
    std::vector<Ruling> rulings(open.size());
    auto next = ruled.begin();
    for (std::size_t i = 0; i < open.size(); ++i) {
        if (!are_heard(open[i])) continue;
        Ruling& r = rulings[i];
        if (!open[i].candidate_invalid) r.candidate = *next++;
        if (!open[i].reference_invalid) r.reference = *next++;
    }
    return rulings;
}

PixelClass class_of(const OpenPixel& open, const Ruling& ruling) {
    if (open.candidate_invalid) return PixelClass::invalid;
    const Standing candidate = ruling.candidate.decision.standing,
                   reference = ruling.reference.decision.standing;
    if (!is_lawful(candidate)) return class_of(candidate, reference);
    if (!open.candidate_depth_lawful) return PixelClass::wrong_depth;
    if (open.reference_invalid || !open.reference_depth_lawful) return PixelClass::reference_wrong;
    return class_of(candidate, reference);
}

}  // namespace zproof
