#include "compare/adjudication.h"

namespace zproof {

Rulings rule_on(const Scene& scene, const View& view, const Witness& candidate, const Witness& reference,
                std::span<const PixelPlace> open) {
    const std::size_t triangle_count = scene.triangles.size();
    Hearing hearing(scene, view);
    hearing.expect(2 * open.size());
    const auto plead = [&](const Witness& witness, const Answer& answer, const PixelPlace& place) {
        if (is_invalid(answer, triangle_count))
            hearing.add_none();
        else
            hearing.add(witness.bounds(), answer.primitive, place.x, place.y);
    };
    for (const PixelPlace& place : open) {
        const Answer ours = candidate.answer_at(place.x, place.y),
                     theirs = reference.answer_at(place.x, place.y);
        if (ours.primitive == theirs.primitive) {
            hearing.add_none();
            hearing.add_none();
        } else {
            plead(candidate, ours, place);
            plead(reference, theirs, place);
        }
    }
    return Rulings(hearing.hear(Asked::standing_and_displacement));
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
