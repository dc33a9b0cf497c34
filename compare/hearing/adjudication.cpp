#include "compare/hearing/adjudication.h"

#include <tbb/parallel_for.h>

namespace zproof {

Rulings rule_on(const Scene& scene, const View& view, const Witness& candidate, const Witness& reference,
                std::span<const PixelPlace> open) {
    const std::size_t triangle_count = scene.triangles.size();
    std::vector<Plea> pleas(2 * open.size());
    const auto plead = [&](const Witness& witness, const Answer& answer, const PixelPlace& place,
                           Plea& plea) {
        if (!is_invalid(answer, triangle_count))
            plea = {&witness.bounds(), answer.primitive, place.x, place.y};
    };
    tbb::parallel_for(std::size_t(0), open.size(), [&](std::size_t i) {
        const PixelPlace& place = open[i];
        const Answer ours = candidate.answer_at(place.x, place.y),
                     theirs = reference.answer_at(place.x, place.y);
        if (ours.primitive == theirs.primitive) return;
        plead(candidate, ours, place, pleas[2 * i]);
        plead(reference, theirs, place, pleas[2 * i + 1]);
    });
    return Rulings(Hearing(scene, view).hear(std::move(pleas), Asked::standing_and_displacement));
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
